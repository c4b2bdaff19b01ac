# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error tables and machine files of other systems: what each can hold, what it cannot, and the sign it means."""
