# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed loop: measurement -> identification -> tracing -> prediction.  numpy only; runs without FreeCAD."""
