# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Files of runs as objects. A file that cannot be read is a BrokenInput."""
