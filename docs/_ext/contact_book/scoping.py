"""Restores the namespace of the members of a header's group.

Doxygen lists what a header declares in the header's group (docs/group_filter.py), and Breathe then
shows every function without its namespace, so that no reference finds it. Breathe takes the
namespace from the compound that holds a member, so that compound is made to say it.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path


def _names(group: ET.Element) -> Iterator[str]:
    """Qualified names of everything in the group."""
    for member in group.iter("memberdef"):
        yield member.findtext("qualifiedname", "")
    for inner in [*group.iter("innerclass"), *group.iter("innerconcept")]:
        yield inner.text or ""


def _scope(names: list[str]) -> str:
    """The namespace the names share: the shortest of their scopes."""
    scopes = [name.rpartition("::")[0] for name in names if "::" in name]
    return min(scopes, key=len, default="")


def restore_scope(path: Path) -> None:
    """Rewrites one group's XML: its namespace, without members that belong to a class."""
    tree = ET.parse(path)
    group = tree.find("compounddef")
    if group is None or group.get("kind") != "group":
        return
    scope = _scope(list(_names(group)))
    if not scope:
        return
    group.set("kind", "namespace")
    name = group.find("compoundname")
    if name is not None:
        name.text = scope
    for inner in group.iter("innerclass"):
        shorten(path.with_name(f"{inner.get('refid')}.xml"), f"{scope}::")
    for section in list(group.iter("sectiondef")):
        for member in list(section.iter("memberdef")):
            if member.findtext("qualifiedname", "").rpartition("::")[0] != scope:
                section.remove(member)
    tree.write(path, encoding="utf-8", xml_declaration=True)


def shorten(path: Path, scope: str) -> None:
    """Takes the scope from a class's name: Breathe puts the holding compound's before it."""
    tree = ET.parse(path)
    name = tree.find("compounddef/compoundname")
    if name is not None:
        name.text = (name.text or "").removeprefix(scope)
        tree.write(path, encoding="utf-8", xml_declaration=True)


def rename_in_index(path: Path) -> None:
    """Lists the groups as namespaces under their own names, so that a page can ask for one."""
    tree = ET.parse(path)
    for compound in tree.iter("compound"):
        if compound.get("kind") == "group":
            compound.set("kind", "namespace")
    tree.write(path, encoding="utf-8", xml_declaration=True)


def restore_scopes(folder: Path) -> None:
    """Rewrites the XML of every header's group."""
    for path in sorted(folder.glob("group__header__*.xml")):
        restore_scope(path)
    rename_in_index(folder / "index.xml")
