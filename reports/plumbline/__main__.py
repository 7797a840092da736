"""`python -m plumbline FILE`: what a result file holds, and its tables as CSV."""

import sys

from plumbline.reader import main

sys.exit(main())
