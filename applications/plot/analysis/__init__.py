# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Facts from histories and fields: arrivals, peaks, paths."""
