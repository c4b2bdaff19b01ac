# SPDX-License-Identifier: LGPL-2.1-or-later
"""An animated GIF of PNG pictures, by Pillow, which comes with FreeCAD's matplotlib; None where it is missing."""

from __future__ import annotations

import io
from collections.abc import Sequence


def available() -> bool:
    """Whether a GIF can be written."""
    try:
        from PIL import Image  # noqa: F401
    except ImportError:
        return False
    return True


def animated(pictures: Sequence[bytes], milliseconds: int) -> bytes | None:
    """The GIF that shows PNG pictures one after the other, for ever; None without Pillow or without a picture."""
    if not pictures or not available():
        return None
    from PIL import Image

    frames = [Image.open(io.BytesIO(data)).convert("RGB").quantize(colors=255) for data in pictures]
    out = io.BytesIO()
    frames[0].save(out, "GIF", save_all=True, append_images=frames[1:], duration=milliseconds, loop=0)
    return out.getvalue()
