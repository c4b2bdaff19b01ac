# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small faults for `tools/mutation.py`: one changed operator, number, condition or statement of a module at a time.

Left alone: annotations, texts and docstrings, and what stands inside `raise`, because those are the fields of messages.
"""

from __future__ import annotations

import ast
import copy
from dataclasses import dataclass

SWAPPED = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult,
    ast.Mod: ast.Mult, ast.Pow: ast.Mult, ast.BitOr: ast.BitAnd, ast.BitAnd: ast.BitOr, ast.BitXor: ast.BitOr,
    ast.LShift: ast.RShift, ast.RShift: ast.LShift,
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip
PAIRS = [("min", "max"), ("any", "all"), ("sin", "cos"), ("minimum", "maximum"), ("argmin", "argmax"),
         ("floor", "ceil"), ("nanmin", "nanmax"), ("lower", "upper"), ("zeros", "ones")]  # fmt: skip
RENAMED = dict(PAIRS) | {b: a for a, b in PAIRS}


@dataclass(frozen=True)
class Mutant:
    """line : of the change.  function : (qualified name, first line) of the outermost function it is in, or None for
    the body of the module or of a class.  what : words.  number : of the change in its module."""

    path: str
    number: int
    line: int
    function: tuple[str, int] | None
    what: str


def _changes(node: ast.AST, commutes: bool = False):
    """(words, function that makes the change in a copy of the node and returns what replaces it).

    commutes : the node is a product `@` of vectors.
    """

    def name(cls):
        return cls.__name__

    if isinstance(node, (ast.BinOp, ast.AugAssign, ast.BoolOp)):
        other = SWAPPED.get(type(node.op))
        if other:
            yield f"{name(type(node.op))} -> {name(other)}", lambda n: _set(n, "op", other())
        elif isinstance(node, ast.BinOp) and not commutes and ast.dump(node.left) != ast.dump(node.right):
            yield "MatMult: sides exchanged", lambda n: _set(_set(n, "left", n.right), "right", node.left)
    if isinstance(node, ast.Compare):
        for i, op in enumerate(node.ops):
            yield f"{name(type(op))} -> {name(SWAPPED[type(op)])}", lambda n, i=i, op=op: _item(n.ops, i, op, n)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
        yield f"{name(type(node.op))} left out", lambda n: n.operand
    if isinstance(node, (ast.If, ast.While, ast.IfExp)):
        plain = not isinstance(node.test, (ast.Compare, ast.BoolOp)) and not (
            isinstance(node.test, ast.UnaryOp) and isinstance(node.test.op, ast.Not)
        )
        if plain:
            yield "condition negated", lambda n: _set(n, "test", ast.UnaryOp(ast.Not(), n.test))
    if isinstance(node, ast.Constant):
        v = node.value
        if isinstance(v, bool):
            yield f"{v} -> {not v}", lambda n: ast.Constant(not v)
        elif isinstance(v, int):
            yield f"{v} -> {v + 1}", lambda n: ast.Constant(v + 1)
        elif isinstance(v, float):
            new = _other(v)
            yield f"{v} -> {new}", lambda n: ast.Constant(new)
    if isinstance(node, ast.Attribute) and node.attr in RENAMED and isinstance(node.ctx, ast.Load):
        yield f"{node.attr} -> {RENAMED[node.attr]}", lambda n: _set(n, "attr", RENAMED[n.attr])
    if isinstance(node, ast.Name) and node.id in ("min", "max", "any", "all") and isinstance(node.ctx, ast.Load):
        yield f"{node.id} -> {RENAMED[node.id]}", lambda n: _set(n, "id", RENAMED[n.id])
    if isinstance(node, ast.Raise):
        yield "raise left out", lambda n: ast.Pass()
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield "statement left out", lambda n: ast.Pass()
    if isinstance(node, ast.Continue):
        yield "continue -> break", lambda n: ast.Break()
    if isinstance(node, ast.Break):
        yield "break -> continue", lambda n: ast.Continue()


def _other(v: float) -> float:
    """Half as much again; a tolerance, or a guard against division by zero, so large that it must matter."""
    if 0 < v < 1e-100:
        return 1.0
    return v**0.5 if 0 < v <= 1e-6 else v * 1.5 if v else 1.0


def _set(node, field, value):
    setattr(node, field, value)
    return node


def _item(ops, i, op, node):
    ops[i] = SWAPPED[type(op)]()
    return node


class _Walk(ast.NodeTransformer):
    """Counts every change there is; makes the one with the number `wanted`."""

    def __init__(self, path: str, wanted: int | None = None):
        self.path, self.wanted, self.found, self.names, self.outer = path, wanted, [], [], None
        self.scalars: list[ast.AST] = []  # float(a @ b): vectors, whose order does not matter

    def visit(self, node):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            return self._definition(node)
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "float":
            self.scalars += node.args
        result = node
        for words, make in _changes(node, node in self.scalars):
            number = len(self.found)
            self.found.append(Mutant(self.path, number, node.lineno, self.outer, words))
            if number == self.wanted:
                result = make(copy.copy(node) if not isinstance(node, ast.Compare) else copy.deepcopy(node))
                ast.copy_location(result, node)
        if isinstance(node, ast.Raise):
            return result
        if isinstance(node, ast.AnnAssign):
            if node.value is not None:
                new = self.visit(node.value)
                result = _set(copy.copy(node), "value", new) if new is not node.value else node
            return result
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return node
        if result is not node:
            self._count_only(node)
            return result
        return self.generic_visit(node)

    def _count_only(self, node):
        """Count the changes below a node that was changed itself."""
        wanted, self.wanted = self.wanted, None
        self.generic_visit(copy.deepcopy(node))
        self.wanted = wanted

    def _definition(self, node):
        outer = self.outer
        self.names.append(node.name)
        is_function = not isinstance(node, ast.ClassDef)
        if is_function:
            for i, default in enumerate(node.args.defaults):
                node.args.defaults[i] = self.visit(default)
            node.args.kw_defaults = [d if d is None else self.visit(d) for d in node.args.kw_defaults]
            if outer is None:
                first = min([node.lineno, *(d.lineno for d in node.decorator_list)])
                self.outer = (".".join(self.names), first)
        node.body = [self.visit(statement) for statement in node.body]
        self.names.pop()
        self.outer = outer
        return node


def mutants_of(path: str, source: str) -> list[Mutant]:
    """Every change of a module, in the order of its text."""
    walk = _Walk(path)
    walk.visit(ast.parse(source))
    return walk.found


def mutated(path: str, source: str, number: int) -> ast.Module:
    """The module with the change of that number."""
    tree = _Walk(path, number).visit(ast.parse(source))
    return ast.fix_missing_locations(tree)
