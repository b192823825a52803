"""Two node types: a component of the page, and a slot in it that holds ordinary content."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from docutils import nodes


class component(nodes.General, nodes.Element):  # noqa: N801 (docutils names nodes so)
    """Something the page brings to life. `kind` picks its renderer; `data` is what that needs."""


class slot(nodes.General, nodes.Element):  # noqa: N801
    """One named field of a component, as parsed content, so that search and mathematics see it."""


def make_slot(name: str, children: Sequence[nodes.Node]) -> slot:
    node = slot(name=name)
    node += list(children)
    return node


def make_component(kind: str, data: dict[str, Any], slots: Sequence[slot] = ()) -> component:
    node = component(kind=kind, data=data)
    node += list(slots)
    return node
