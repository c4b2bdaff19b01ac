# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine as FreeCAD objects: placements in, lever arms and indices out.  Never imports the window."""
