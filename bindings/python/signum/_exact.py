"""Numbers as doubles: every one as it is, or not at all."""

import numpy as np


def doubles(numbers):
    """An array of doubles, aligned, of the numbers given.

    Lists, arrays of other types, integers, fractions. Raises ValueError, naming the row, for a number
    that no double is: a coordinate is taken as an exact number and is not rounded on the way in.
    """
    if isinstance(numbers, np.ma.MaskedArray):
        raise ValueError("a masked array: fill what is masked, or leave it out")
    given = np.asarray(numbers)
    # A list of integers and floats, or a table of such columns, has been rounded on its way to an array.
    if not isinstance(numbers, np.ndarray) and given.dtype.kind == "f" and np.any(np.abs(given) >= 2**53):
        given = np.asarray(numbers, dtype=object)
    if given.dtype.kind == "f" and given.dtype.itemsize <= 8 or given.size == 0:
        return np.require(given, np.float64, ["ALIGNED"])
    if given.dtype.kind in "iu":
        result = given.astype(np.float64)
        limit = 2**53
        if given.dtype.itemsize <= 4 or (int(given.min()) >= -limit and int(given.max()) <= limit):
            return result
        given = given.astype(object)
    elif given.dtype.kind in "bcSUMmV":
        raise ValueError(f"numbers are needed, not {given.dtype}")
    with np.errstate(over="ignore"):
        try:
            result = given.astype(np.float64)
        except OverflowError:
            raise ValueError("there is a number beyond the doubles") from None
        except (TypeError, ValueError):
            raise ValueError("all must be numbers, and as many in each row") from None
    wrong = np.array([not (is_same(a, b) or b != b) for a, b in zip(given.flat, result.flat)])
    if wrong.any():
        where = np.unravel_index(int(wrong.argmax()), given.shape)
        raise ValueError(f"row {where[0] if where else 0} has {given[where]}, which is no double")
    return result


def is_same(number, double):
    """Whether they are equal as exact numbers: a float would be compared to an integer as such."""
    return (number.item() if isinstance(number, np.generic) else number) == float(double)
