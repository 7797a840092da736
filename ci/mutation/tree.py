"""Sites of mutation, and what a syntax tree of clang says of an expression: its text, its operator, the kind of its numbers."""

import re
from dataclasses import dataclass

from clang.cindex import CursorKind as Kind
from clang.cindex import TypeKind

INTEGERS = {TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG,
            TypeKind.SHORT, TypeKind.USHORT}  # fmt: skip
REALS = {TypeKind.DOUBLE, TypeKind.FLOAT, TypeKind.LONGDOUBLE}
NUMBERS_OF_CLASS = re.compile(r"\b(Pack|Bounded|State)\b|\bEigen::")  # classes with a product from the left with a double
BINARY = {Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.CALL_EXPR}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
SYMBOL = re.compile(r"\s*([-+*/]=?|[<>]=?|[=!]=|&&|=)\s*")


@dataclass(frozen=True)
class Site:
    operator: str
    file: str
    start: int  # characters, not bytes
    find: str
    replace: str
    wrap: str = "expression"
    type: str = ""  # of wrap "factor" the factor, of "skip" the condition

    @property
    def end(self):
        return self.start + len(self.find)


def kind_of(cursor_type):
    """"real", "class" (of numbers), "dependent", "int" or ""."""
    canonical = cursor_type.get_canonical()
    if canonical.kind in (TypeKind.LVALUEREFERENCE, TypeKind.RVALUEREFERENCE):
        canonical = canonical.get_pointee().get_canonical()
    if canonical.kind in REALS:
        return "real"
    if canonical.kind in INTEGERS:
        return "int"
    if canonical.kind in (TypeKind.DEPENDENT, TypeKind.AUTO) or canonical.spelling.startswith("type-parameter"):
        return "dependent"
    if canonical.kind not in (TypeKind.POINTER, TypeKind.BOOL) and NUMBERS_OF_CLASS.search(canonical.spelling):
        return "class"
    return ""


class Expressions:
    """Those of one source."""

    def __init__(self, source):
        self.bytes = source

    def text(self, start, end):
        return self.bytes[start:end].decode()

    def of(self, cursor):
        return self.text(*self.span(cursor))

    @staticmethod
    def span(cursor):
        extent = cursor.extent
        return extent.start.offset, extent.end.offset

    def parts(self, cursor, children=None):
        """(operator, left, right) of a binary operation, built in or overloaded; None of anything else."""
        if cursor.kind not in BINARY:
            return None
        children = list(cursor.get_children()) if children is None else children
        if cursor.kind == Kind.CALL_EXPR:
            children = children[::2] if len(children) == 3 else []
        if len(children) != 2:
            return None
        between = self.text(self.span(children[0])[1], self.span(children[1])[0])
        found = SYMBOL.fullmatch(COMMENT.sub("", between))
        return (found.group(1), *children) if found else None

    def bare(self, cursor):
        """Without the conversions that the compiler adds."""
        while cursor.kind in (Kind.UNEXPOSED_EXPR, Kind.CALL_EXPR):
            own = list(cursor.get_children())
            if len(own) != 1 or self.span(own[0]) != self.span(cursor):
                break
            cursor = own[0]
        return cursor

    def leaves(self, cursor, symbols):
        found = self.parts(self.bare(cursor))
        if not found or found[0] not in symbols:
            return [cursor]
        return self.leaves(found[1], symbols) + self.leaves(found[2], symbols)
