#ifndef EXPECT_H
#define EXPECT_H
/* What the programs here ask: each counts what is not as it should be, says where, and ends with
 * it. */

#include <stdio.h>
#include <string.h>

static int mistakes = 0;

#define EXPECT(condition)                                                   \
    do {                                                                    \
        if (!(condition)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            ++mistakes;                                                     \
        }                                                                   \
    } while (0)

/* A call that succeeds, and leaves no complaint. */
#define SUCCEEDS(call)                                                                      \
    do {                                                                                    \
        const signum_status status_ = (call);                                               \
        if (status_ != SIGNUM_OK || error.status != SIGNUM_OK || error.site != -1 ||        \
            error.message[0] != '\0') {                                                     \
            fprintf(stderr, "%s:%d: %s: %d, %s\n", __FILE__, __LINE__, #call, (int)status_, \
                    error.message);                                                         \
            ++mistakes;                                                                     \
        }                                                                                   \
    } while (0)

/* A call that is refused with that status, naming that site, in words. */
#define FAILS(call, expected, about)                                                        \
    do {                                                                                    \
        const signum_status status_ = (call);                                               \
        if (status_ != (expected) || error.status != (expected) || error.site != (about) || \
            error.message[0] == '\0') {                                                     \
            fprintf(stderr, "%s:%d: %s: %d, site %d, %s\n", __FILE__, __LINE__, #call,      \
                    (int)status_, (int)error.site, error.message);                          \
            ++mistakes;                                                                     \
        }                                                                                   \
    } while (0)
#define REFUSED(call) FAILS(call, SIGNUM_INVALID_ARGUMENT, -1)

#endif
