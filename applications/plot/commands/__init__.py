# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""One module for each command of plot.py. Its docstring is the help text, and
the parameters of its main() are the arguments."""
