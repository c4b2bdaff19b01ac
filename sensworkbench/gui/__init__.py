# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window: commands, panels, view providers, colours, legend.  A panel edits and shows; it never computes."""
