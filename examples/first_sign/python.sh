#!/bin/sh -e
cat >first.py <<'END'
import signum
print(signum.ccw((0.1, 0.2), (0.3, 0.4), (0.8, 0.9)))  # doubles say 1
END
"${PYTHON:-python3}" first.py
