# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user asks for, computed: sensitivity, trace, plan, prediction, compensation tables, map of the error.

Each study is a function from a request to a result, with progress.  The command line, batch runs, documents and the
window call the same functions; `formats` writes their results and the window shows them.
"""
