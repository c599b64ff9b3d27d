# SPDX-License-Identifier: BSD-3-Clause
"""Finds circles in a graph."""


def find_circle(graph):
    """The nodes of one circle, in the order of its edges; none if there is no circle.
    graph: node -> nodes that its edges lead to."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node) :]
        if node in done:
            return []
        path.append(node)
        for target in sorted(graph.get(node, ())):
            circle = visit(target)
            if circle:
                return circle
        path.pop()
        done.add(node)
        return []

    for node in sorted(graph):
        circle = visit(node)
        if circle:
            return circle
    return []
