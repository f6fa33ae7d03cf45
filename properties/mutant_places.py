"""Where generated_mutants.py may break a source, and what it writes there: Clang's parser (libclang) finds the places.

A mutant changes one expression of one line: a comparison (`<` to `<=`, `==` to `!=` ...), `and` to `or`, a sum to a
difference, a sign, a number, what a function returns, the lesser of two to the larger, the order of two arguments of one
type. Or it leaves out a statement, or what an `if` does.
"""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What takes the place of an operator.
OTHER = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
         "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"]}

NOTHING, NEVER = "left out", "never"  # of a statement, and of what an `if` does
# Of these the order of two arguments makes no difference.
SYMMETRIC = {"min", "max", "minmax", "swap", "inner_product", "squared_distance"}


class Mutant:
    """`place` and `end` enclose the expression that is asked for anew, and `text` is it when mutated; `token` (offset,
    length) is what the description encloses in «»."""

    def __init__(self, file, source, place, end, text, token, other):
        self.file, self.place, self.end, self.text = file, place, end, text
        start = source.rfind("\n", 0, token[0]) + 1
        stop = source.find("\n", token[0])
        self.line_number = source.count("\n", 0, start) + 1
        cut = min(token[0] + token[1], stop)
        pieces = [piece.encode("latin-1").decode() for piece in (source[start:token[0]], source[token[0]:cut], source[cut:stop])]
        self.line = "{}«{}»{}".format(*pieces).strip()
        self.other = other

    def asked(self, expression):
        """The expression that asks whether it is this mutant's turn."""
        turn = f"circumspect_mutated({self.number})"
        if self.other == NOTHING:
            return f"({turn} ? (void)0 : (void)({expression}))"
        if self.other == NEVER:
            return f"({turn} ? false : static_cast<bool>({expression}))"
        return f"({turn} ? ({self.text}) : ({expression}))"

    def key(self):
        return self.file, self.line, self.other


def outside_macros(unit, cindex, name):
    """Whether an extent has nothing to do with a macro."""
    inside = [(c.extent.start.offset, c.extent.end.offset) for c in unit.cursor.get_children()
              if c.kind == cindex.CursorKind.MACRO_INSTANTIATION and c.location.file and c.location.file.name == name]
    return lambda start, end: not any(a < end and start < b for a, b in inside)


def generated(file):
    """The mutants of a file, in the order of their places."""
    from clang import cindex
    source_bytes = (ROOT / file).read_bytes()
    # Offsets are those of bytes: the text is taken as one character a byte.
    source = source_bytes.decode("latin-1")
    K = cindex.CursorKind
    unit = cindex.Index.create().parse(
        str(ROOT / file), args=["-x", "c++", "-std=c++20", f"-I{ROOT}", f"-I{ROOT}/include", "-ferror-limit=0"],
        options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    name = str(ROOT / file)
    outside = outside_macros(unit, cindex, name)
    found = []

    def text(a, b):
        return source[a:b]

    def add(cursor, mutated, token, other):
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        # The lines that the compiler names have to stay what they are.
        if start < end and outside(start, end) and "//" not in mutated:
            found.append(Mutant(file, source, start, end, mutated.replace("\n", " "), token, other))

    def is_number(cursor):
        return cursor.type.get_canonical().kind.name in (
            "INT", "UINT", "LONG", "ULONG", "LONGLONG", "ULONGLONG", "DOUBLE", "SCHAR", "UCHAR", "SHORT", "USHORT", "CHAR_S")

    def is_bool(cursor):
        return cursor.type.get_canonical().kind.name == "BOOL"

    def call(cursor):
        """Two arguments of one type in the other order; the lesser for the larger."""
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        for name, other in (("std::min(", "std::max("), ("std::max(", "std::min(")):
            if text(start, end).startswith(name):
                add(cursor, other + text(start + len(name), end), (start, len(name) - 1), other[:-1])
        given = list(cursor.get_arguments())
        if cursor.spelling in SYMMETRIC or cursor.spelling.startswith("operator"):
            return
        for a, b in zip(given, given[1:]):
            (first, last), (begin, stop) = ((x.extent.start.offset, x.extent.end.offset) for x in (a, b))
            alike = a.type.get_canonical().spelling == b.type.get_canonical().spelling
            of_range = re.search(r"(begin|end)\(\)$", text(first, last)) or re.search(r"(begin|end)\(\)$", text(begin, stop))
            if alike and not of_range and first < last <= begin < stop and text(first, last) != text(begin, stop):
                swapped = text(start, first) + text(begin, stop) + text(last, begin) + text(first, last) + text(stop, end)
                add(cursor, swapped, (first, stop - first), "swapped")

    def constant(cursor):
        """Whether what stands here has to be known to the compiler."""
        start = cursor.extent.start.offset
        if cursor.kind in (K.STATIC_ASSERT, K.ENUM_CONSTANT_DECL, K.TEMPLATE_NON_TYPE_PARAMETER,
                           K.TEMPLATE_TYPE_PARAMETER, K.TYPE_ALIAS_DECL, K.TYPE_ALIAS_TEMPLATE_DECL,
                           K.TYPE_REF, K.TEMPLATE_REF, K.FIELD_DECL):
            return True
        if cursor.kind in (K.FUNCTION_DECL, K.CXX_METHOD, K.FUNCTION_TEMPLATE, K.VAR_DECL, K.CONSTRUCTOR):
            head = re.split(r"[({=]", text(max(0, start - 60), cursor.extent.end.offset)[min(60, start):], maxsplit=1)[0]
            return re.search(r"\bconst(expr|eval|init)\b|\bstatic const\b", head) is not None
        return False

    def binary(cursor):
        children = list(cursor.get_children())
        operands = [children[0], children[-1]]
        between = (operands[0].extent.end.offset, operands[1].extent.start.offset)
        match = re.fullmatch(r"\s*([<>=!&|+*/-]+)\s*", text(*between))
        if not match or match[1] not in OTHER:
            return
        operator, at = match[1], between[0] + match.start(1)
        if operator in ("+", "-") and not (is_number(cursor) and all(is_number(o) for o in operands)):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        for other in OTHER[operator]:
            add(cursor, text(start, at) + other + text(at + len(operator), end), (at, len(operator)), other)

    def visit(cursor, parent):
        if constant(cursor):
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        children = list(cursor.get_children())
        if cursor.kind == K.IF_STMT and re.match(r"if\s+constexpr\b", text(start, end)):
            for child in children[1:]:
                visit(child, cursor)
            return
        if cursor.kind == K.CASE_STMT:
            for child in children[1:]:
                visit(child, cursor)
            return
        if cursor.kind == K.DECL_STMT and re.match(r"(static\s+)?constexpr\b", text(start, end)):
            return
        if cursor.kind == K.BINARY_OPERATOR and len(children) == 2:
            binary(cursor)
        elif cursor.kind == K.CALL_EXPR and re.match(r"operator([<>=!]=?)$", cursor.spelling) and len(children) == 3:
            binary(cursor)
        elif cursor.kind == K.CALL_EXPR:
            call(cursor)
        elif cursor.kind == K.IF_STMT and children and children[0].kind.is_expression():
            if not text(start, end).startswith("if constexpr"):
                add(children[0], "", (start, 2), NEVER)
        elif cursor.kind == K.UNARY_OPERATOR and len(children) == 1 and source[start] in "!-" and source[start + 1] != source[start]:
            # What `!` stands before may be of a class, and is then asked as a condition is.
            if source[start] == "!" and source[start + 1] != "=":
                add(cursor, f"!!({text(start + 1, end)})", (start, 1), "")
            elif source[start] == "-" and is_number(cursor):
                add(cursor, f"({text(start + 1, end)})", (start, 1), "")
        elif cursor.kind == K.RETURN_STMT and len(children) == 1:
            child = children[0]
            a, b = child.extent.start.offset, child.extent.end.offset
            if is_bool(child):
                add(child, f"!({text(a, b)})", (start, 6), "return !")
            elif child.type.get_canonical().kind.name == "INT" and not text(a, b).strip() == "0":
                add(child, f"-({text(a, b)})", (start, 6), "return -")
        elif cursor.kind == K.INTEGER_LITERAL and parent.kind not in (K.INIT_LIST_EXPR, K.VAR_DECL):
            number = text(start, end)
            if re.fullmatch(r"\d+", number):
                other = str(int(number) - 1) if int(number) > 1 else str(1 - int(number))
                add(cursor, other, (start, end - start), other)
        for child in children:
            if cursor.kind == K.COMPOUND_STMT and child.kind.is_expression():
                first, last = child.extent.start.offset, child.extent.end.offset
                add(child, "", (first, last - first), NOTHING)
            visit(child, cursor)

    def top(cursor):
        for child in cursor.get_children():
            if child.location.file is None or child.location.file.name != name:
                continue
            visit(child, cursor)

    top(unit.cursor)
    unique = {}
    for mutant in sorted(found, key=lambda m: (m.place, -m.end, m.text)):
        unique.setdefault((mutant.place, mutant.end, mutant.text), mutant)
    # A line that stands twice in a file has one description: the first is the one that is tried.
    first = {}
    for mutant in unique.values():
        first.setdefault(mutant.key(), mutant)
    return list(first.values())
