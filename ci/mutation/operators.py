"""What each operator of mutation makes of a syntax tree: the sites where it applies, and the sites it must leave alone.

    coefficient   a product or quotient of real numbers, or a number that stands alone, 2 % larger
    term          an operand of a sum, what += adds, or an entry in the ledger, left out
    sign          an operand of a sum after the first, what += adds, or a negation, with the other sign
    comparison    of whole numbers with or without equality, of real ones the other way round, == for !=
    index         the element before (of the first the second)
    range         the first or the last pass of a loop left out
    column        a column of points left out of a loop over columns, or a statement on a column left out
    stage         a stage that an integrator calls left out

A site must be able to stand beside its clean form in one program. Where the language wants a constant (constexpr, default
arguments, labels, `if constexpr`) no switch can stand; what throws an error or words a message computes nothing; 2 % of a
tolerance are within it, and do not change the sign of a number of which a comparison with zero reads nothing else. All four are
counted and not drawn.
"""

import re
from collections import Counter
from typing import NamedTuple

from clang.cindex import CursorKind as Kind

from .tree import BINARY, Expressions, Site, kind_of

OPERATORS = ("coefficient", "term", "sign", "comparison", "index", "range", "column", "stage")
PERCENT_2 = "1.02"
# 2 % of a tolerance or of a bound on rounding is less than it tolerates.
SMALLEST = 1e-5
TOLERANCE = re.compile(r"\brounding::|\bepsilon\(\)")
SHARE = re.compile(r"([\d.]+[eE]-\d+) \*")  # a tolerance times a size
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.FUNCTION_TEMPLATE, Kind.CONSTRUCTOR, Kind.CONVERSION_FUNCTION}
MESSAGES = {"format", "print", "format_to", "to_string"}
WHOLE_SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
REAL_SWAPS = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "!=", "!=": "=="}
LITERAL = re.compile(r"[\d.]+(?:[eE][-+]?\d+)?")


class PointColumns(NamedTuple):
    """The names of all columns of points, and of those that each function that lists some names, by the function's name."""

    all: tuple = ()
    listed: dict = {}


class Walk(Expressions):
    """Collects the sites of one file."""

    def __init__(self, file, source, columns=PointColumns()):
        super().__init__(source)
        self.file, self.columns = file, columns
        self.sites, self.excluded = {}, Counter()
        self._operands_of_sums, self._conditions_of_loops, self._signs_alone = set(), set(), set()

    def emit(self, operator, start, end, replace, why, wrap="expression", more=""):
        find = self.text(start, end)
        if not find or find == replace or "\n#" in find:
            return
        if why:
            self.excluded[operator, why] += 1
            return
        site = Site(operator, self.file, len(self.text(0, start)), find, replace, wrap, more)
        self.sites[site.start, site.find, site.replace, more] = site

    def scale(self, operator, cursor, kind, factor, why):
        """A number times 1.02, -1 or 0: of a double by two forms, of others by a factor that is 1 in the clean program."""
        start, end = self.span(cursor)
        find = self.text(start, end)
        if LITERAL.fullmatch(find) and not float(find):
            return
        if operator == "coefficient":
            small = LITERAL.fullmatch(find) or SHARE.match(find)
            if TOLERANCE.search(find) or (small and float(small.group(small.lastindex or 0)) < SMALLEST):
                why = why or "tolerance"
            elif self._key(cursor) in self._signs_alone:
                why = why or "sign alone"
        if kind == "real":
            new = {"0": "0.0", "-1": f"-({find})"}.get(factor, f"{factor} * ({find})")
            self.emit(operator, start, end, new, why)
        else:
            self.emit(operator, start, end, f"({factor}.0 * ({find}))".replace("1.02.0", "1.02"), why, "factor", factor)

    # --- the tree ---

    def walk(self, cursor, why="", product=False):
        kind = cursor.kind
        children = list(cursor.get_children())
        why = why or self._why(cursor, children)
        if kind == Kind.CALL_EXPR and cursor.spelling in MESSAGES:
            why = why or "message"
        self._statements(cursor, children, why)
        inside = False
        if kind in BINARY or kind == Kind.UNARY_OPERATOR:
            inside = self._operation(cursor, children, why, product)
        if kind == Kind.FLOATING_LITERAL and not product and LITERAL.fullmatch(self.of(cursor)):
            self.scale("coefficient", cursor, "real", PERCENT_2, why)
        if kind in (Kind.ARRAY_SUBSCRIPT_EXPR, Kind.CALL_EXPR):
            self._indices(cursor, children, why)
        passes_on = kind in (Kind.PAREN_EXPR, Kind.UNEXPOSED_EXPR, Kind.CXX_FUNCTIONAL_CAST_EXPR) or (
            kind == Kind.CALL_EXPR and len(children) == 1  # a conversion
        )
        for number, child in enumerate(children):
            self.walk(child, self._why_child(cursor, children, number, why), inside or (product and passes_on))

    def _why(self, cursor, children):
        kind = cursor.kind
        if kind in FUNCTIONS:
            body = next((self.span(c)[0] for c in children if c.kind == Kind.COMPOUND_STMT), self.span(cursor)[1])
            return "constant" if re.search(r"\b(constexpr|consteval)\b", self.text(self.span(cursor)[0], body)) else ""
        if kind in (Kind.VAR_DECL, Kind.FIELD_DECL):
            head = self.of(cursor).split("=", 1)[0]
            return "constant" if re.search(r"\b(constexpr|constinit)\b", head) else ""
        if kind in (Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.PARM_DECL):
            return "constant"
        if kind in (Kind.TEMPLATE_NON_TYPE_PARAMETER, Kind.TEMPLATE_TYPE_PARAMETER, Kind.TYPE_ALIAS_DECL):
            return "constant"
        if kind == Kind.CXX_THROW_EXPR:
            return "error"
        return ""

    def _why_child(self, cursor, children, number, why):
        if why or number:
            return why
        if cursor.kind == Kind.CASE_STMT:
            return "constant"
        if cursor.kind == Kind.IF_STMT:
            if re.match(r"if\s+constexpr", self.of(cursor)):
                return "constant"
            if len(children) > 1 and self._throws(children[1]):
                return "error"
        return ""

    @staticmethod
    def _throws(statement):
        while statement.kind in (Kind.COMPOUND_STMT, Kind.UNEXPOSED_EXPR, Kind.UNEXPOSED_STMT):
            own = list(statement.get_children())
            if len(own) != 1:
                return False
            statement = own[0]
        return statement.kind == Kind.CXX_THROW_EXPR

    # --- sums, products, comparisons ---

    def _operation(self, cursor, children, why, product):
        """Sites of this operation; True if what is below belongs to a product."""
        found = self.parts(cursor, children)
        kind = kind_of(cursor.type)
        if not found:
            self._negation(cursor, kind, why)
            return False
        symbol, left, right = found
        if symbol in WHOLE_SWAPS:
            self._comparison(cursor, symbol, left, right, why)
            return False
        if not kind or kind == "int":
            return False
        if symbol in ("+", "-") and self._key(cursor) not in self._operands_of_sums:
            for number, leaf in enumerate(self.leaves(cursor, ("+", "-"))):
                self.scale("term", leaf, kind, "0", why)
                if number:
                    self.scale("sign", leaf, kind, "-1", why)
        if symbol in ("+=", "-="):
            if len(self.leaves(right, ("+", "-"))) == 1:
                self.scale("term", right, kind_of(left.type) or kind, "0", why)
            self.scale("sign", right, kind_of(left.type) or kind, "-1", why)
        if symbol in ("*", "/") and not product:
            self.scale("coefficient", cursor, kind, PERCENT_2, why)
        if symbol in ("*=", "/=") and len(self.leaves(right, ("*", "/"))) == 1:
            self.scale("coefficient", right, kind_of(left.type) or kind, PERCENT_2, why)
            return True
        if symbol in ("+", "-"):
            self._operands_of_sums.update(self._key(self.bare(part)) for part in (left, right))
        return symbol in ("*", "/")

    def _key(self, cursor):
        return (*self.span(cursor), cursor.kind)

    def _negation(self, cursor, kind, why):
        start, end = self.span(cursor)
        if not kind or kind == "int" or not re.match(r"-[^-]", self.text(start, end)) or cursor.kind == Kind.BINARY_OPERATOR:
            return
        if cursor.kind == Kind.CALL_EXPR and cursor.spelling not in ("operator-", ""):
            return
        if kind == "real":
            self.emit("sign", start, end, f"({self.text(start + 1, end)})", why)
        else:
            self.scale("sign", cursor, kind, "-1", why)

    def _comparison(self, cursor, symbol, left, right, why):
        kinds = {kind_of(self.bare(side).type) for side in (left, right)}
        if "" in kinds or self._key(cursor) in self._conditions_of_loops:
            return
        for side, other in ((left, right), (right, left)):
            if self.of(other) in ("0", "0.0"):
                self._signs_alone.add(self._key(self._in_brackets(side)))
        new = (WHOLE_SWAPS if kinds == {"int"} else REAL_SWAPS)[symbol]
        self.emit("comparison", *self.span(cursor), f"{self.of(left)} {new} {self.of(right)}", why)

    def _in_brackets(self, cursor):
        cursor = self.bare(cursor)
        return self._in_brackets(next(cursor.get_children())) if cursor.kind == Kind.PAREN_EXPR else cursor

    # --- indices and ranges ---

    def _indices(self, cursor, children, why):
        if cursor.kind == Kind.ARRAY_SUBSCRIPT_EXPR:
            indices = children[1:2]
        elif cursor.spelling in ("operator[]", "operator()") and len(children) > 2:
            owner = cursor.referenced.semantic_parent if cursor.referenced else None
            if owner is None or not owner.spelling or "lambda" in owner.spelling:
                return
            indices = children[2:]
        else:
            return
        for index in indices:
            if kind_of(self.bare(index).type) != "int":
                continue
            find = self.of(index)
            if re.fullmatch(r"\d+", find):
                self.emit("index", *self.span(index), str(int(find) - 1 if int(find) else 1), why)
            elif not re.search(r"\+\+|--|=", find):
                self.emit("index", *self.span(index), f"({find}) > 0 ? ({find}) - 1 : ({find})", why)

    def _range(self, children, why):
        heads = children[:-1]
        text = "".join(self.of(head) for head in heads[1:])
        down = "--" in text
        for head in heads:
            for variable in head.get_children() if head.kind == Kind.DECL_STMT else ():
                own = [c for c in variable.get_children() if c.kind.is_expression()]
                if own and kind_of(variable.type) == "int":
                    self._shorter(own[-1], "-" if down else "+", why)
            self._condition(head, down, why)

    def _condition(self, head, down, why):
        found = self.parts(self.bare(head))
        if not found:
            return
        symbol, left, right = found
        if symbol == "&&":
            self._condition(left, down, why)
            self._condition(right, down, why)
        elif symbol in ("<", "<=", ">", ">=", "!="):
            self._conditions_of_loops.add(self._key(self.bare(head)))
            if kind_of(self.bare(right).type) == "int":
                self._shorter(right, "+" if down else "-", why)

    def _shorter(self, bound, sign, why):
        find = self.of(bound)
        step = "1" if sign == "+" else f"(({find}) > 0)"
        self.emit("range", *self.span(bound), f"({find}) {sign} {step}", why)

    # --- statements ---

    def _statements(self, cursor, children, why):
        if cursor.kind == Kind.FOR_STMT and children:
            self._range(children, why)
            self._loop_over_columns(cursor, children, why)
        if cursor.kind == Kind.CXX_FOR_RANGE_STMT and children:
            self._loop_over_columns(cursor, children, why)
        if cursor.kind == Kind.CALL_EXPR and cursor.spelling == "for_packs" and len(children) == 4:
            self._shorter(children[1], "+", why)
            self._shorter(children[2], "-", why)
        own = {Kind.COMPOUND_STMT: children, Kind.IF_STMT: children[1:], Kind.FOR_STMT: children[-1:],
               Kind.CXX_FOR_RANGE_STMT: children[-1:]}.get(cursor.kind, ())  # fmt: skip
        for statement in own:
            self._statement(statement, why)

    def _statement(self, statement, why):
        statement = self.bare(statement)
        start, end = self.span(statement)
        stop = re.match(r"\s*;", self.text(end, end + 40))
        if statement.kind not in BINARY or not stop:
            return
        end += stop.end()
        text = self.text(start, end)
        owner = statement.referenced.semantic_parent if statement.kind == Kind.CALL_EXPR and statement.referenced else None
        if owner is not None and owner.spelling == "Stages" and "/integrators/" in self.file:
            self.emit("stage", start, end, "", why, "statement")
        elif statement.kind == Kind.CALL_EXPR and statement.spelling == "book":
            self.emit("term", start, end, "", why, "statement")
        elif re.search(r"\bcolumn::\w+", text) and "[&" not in text and self.file.startswith("kernel/"):
            self.emit("column", start, end, "", why, "statement")

    def _loop_over_columns(self, cursor, children, why):
        head = self.text(self.span(cursor)[0], self.span(children[-1])[0])
        name = _named_column(head, children)
        if not name:
            return
        start = self.span(children[-1])[0]
        first = re.match(r"\{|[\w:]+", self.text(start, start + 80))
        # A list that names its columns holds no others.
        listed = (self.columns.listed.get(call) for call in re.findall(r"(\w+)\(", head))
        named = re.findall(r"column::(\w+)", head) or next(filter(None, listed), self.columns.all)
        for column in named if first else ():
            condition = name % column
            text = first.group()
            new = f"{{ if ({condition}) continue;" if text == "{" else f"if ({condition}) continue; else {text}"
            self.emit("column", start, start + len(text.encode()), new, why, "skip", condition)


def _named_column(head, children):
    """The condition that the loop stands at the column %s, where it is a loop over columns."""
    variable = next((c for c in children if c.kind == Kind.VAR_DECL), None)
    if variable is not None:
        spelling = variable.type.spelling
        if re.search(r"\bColumnId\b", spelling):
            return f'{variable.spelling}{"->" if "*" in spelling else "."}name() == "%s"'
        if re.search(r"\bColumn\b", spelling) and "columns_" in head:
            at = f"static_cast<std::size_t>(&{variable.spelling} - columns_.data())"
            return f'descriptions()[{at}].name == "%s"'
    found = re.search(r"(\w+) < (columns_|known)\.size\(\)", head)
    if not found:
        return ""
    counter, of = found.groups()
    return f'descriptions()[{counter}].name == "%s"' if of == "columns_" else f'known[{counter}].name() == "%s"'
