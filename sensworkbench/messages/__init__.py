# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the program says about its input and its results: a code with values, and one table of sentences.

Code that finds something makes a `Message` (or raises `Refused`); the sentence is looked up where a person reads it, in
the language of that person.  The tables are `<language>/<domain>.json` beside this file, the same codes in each.
"""

from .message import Message, Refused
from .tables import LANGUAGES, template

__all__ = ["LANGUAGES", "Message", "Refused", "template"]
