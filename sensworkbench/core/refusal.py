# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one exception for input that cannot be accepted: what, where, and what to do about it.

Everything that reads or checks user data raises `Refused`.  The command line turns it into exit status 2 and
one message; a task panel shows the same message.  Any other exception is a defect of the program.
"""

from __future__ import annotations


class Refused(ValueError):
    """Input was refused.

    what : the finding, one sentence.  where : file, line, column, or object and property ("" where unknown).
    do : what the user can do about it ("" where `what` says it already).
    """

    def __init__(self, what: str, where: str = "", do: str = ""):
        self.what, self.where, self.do = what, where, do
        super().__init__(self.message)

    @property
    def message(self) -> str:
        text = f"{self.where}: {self.what}" if self.where else self.what
        text = text.rstrip()
        if not text.endswith((".", "!", "?")):
            text += "."
        return f"{text} {self.do}".rstrip()

    def at(self, where: str) -> Refused:
        """The same refusal with an outer place put before its own (a file's path, say)."""
        return Refused(self.what, f"{where}: {self.where}" if self.where else where, self.do)
