# SPDX-License-Identifier: BSD-3-Clause
"""Finds functions in C++, GLSL and Python text, well enough to measure their length."""

import ast
import re

# A comment, a string, a character, or a preprocessor line with its continuations. A
# digit separator (1'000) must not open a character, hence the look-behind.
COMMENT = r"//[^\n]*|/\*.*?\*/"
LITERAL = r'R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-zA-Z])\'(?:\\.|[^\'\\\n])+\''
PREPROCESSOR = r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*"

# A value such as `Size{ 1, 2 }`, also in a constructor's list: no body is written so.
VALUE = r"(?<=\w)\{[^{};]*\}"

NOT_A_FUNCTION = re.compile(r"^\s*(?:namespace|class|struct|enum|union|extern)\b(?![^{]*\)\s*$)")


def blank(match):
    """The same number of lines and characters, all white."""
    return re.sub(r"[^\n]", " ", match.group())


def without_comments(text):
    """C++ or GLSL text with its comments blanked; positions stay."""
    keep_literals = lambda m: m.group() if m.group()[0] in "\"'R" else blank(m)
    return re.sub(LITERAL + "|" + COMMENT, keep_literals, text, flags=re.S)


def bare_code(text):
    """C++ or GLSL text with comments, literals and preprocessor lines blanked."""
    text = re.sub(LITERAL + "|" + COMMENT, blank, text, flags=re.S)
    text = re.sub(PREPROCESSOR, blank, text, flags=re.M)
    return re.sub(VALUE, blank, text)


def opens_function(head):
    """True where the text before an opening brace is the head of a function."""
    if "(" not in head or NOT_A_FUNCTION.match(head):
        return False
    return not head.rstrip().endswith(("=", ",", "(", "return"))


def cpp_functions(text):
    """(name, first line, number of lines) of every function outside other functions."""
    code = bare_code(text)
    found = []
    depth_in_function = 0
    start = 0
    for position, character in enumerate(code):
        if depth_in_function:
            depth_in_function += {"{": 1, "}": -1}.get(character, 0)
            if depth_in_function == 0:
                found.append((name, first, code.count("\n", 0, position) + 2 - first))
                start = position + 1
        elif character == "{" and opens_function(code[start:position]):
            head = code[start:position]
            first = code.count("\n", 0, start + len(head) - len(head.lstrip())) + 1
            words = re.findall(r"([\w:~]+|operator\S+)\s*\(", head)
            name = words[0] if words else "?"
            depth_in_function = 1
        elif character in ";{}":
            start = position + 1
    return found


def python_functions(text):
    """(name, first line, number of lines) of every function."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return [
        (node.name, node.lineno, node.end_lineno - node.lineno + 1)
        for node in ast.walk(ast.parse(text))
        if isinstance(node, kinds)
    ]
