"""`{term}`effective mass`` links to the glossary, enters the index and shows its definition.

The glossary's entries link to the lessons that teach a term, the most important first. The first of
these that has the term, as `{term}` or `{index}`, is where the index and the search lead, under all
names of the entry.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.roles import XRefRole
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.index_entries import split_index_msg
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import slug_of
from contact_book.html import attributes, renders, slots
from contact_book.nodes import component, make_component, make_slot

GLOSSARY = "glossary"
_SEEN = "contact-terms-seen"
_PLACES = "contact_terms"

Entry = tuple[str, str, str, str, str | None]


@dataclass(frozen=True)
class Place:
    """A term of the glossary, and where it is taught: nowhere yet if `page` is empty."""

    names: tuple[str, ...]
    page: str
    anchor: str


class TermRole(XRefRole):
    """As Sphinx's own, and in lessons the first mention of a term is a place in the index."""

    def __init__(self) -> None:
        super().__init__(innernodeclass=nodes.inline, warn_dangling=True)

    def process_link(
        self,
        env: BuildEnvironment,
        refnode: nodes.Element,
        has_explicit_title: bool,
        title: str,
        target: str,
    ) -> tuple[str, str]:
        # The glossary's apostrophes are typographic by the time they are names.
        return title.replace("'", "’"), " ".join(target.split()).replace("'", "’")

    def result_nodes(
        self,
        document: nodes.document,
        env: BuildEnvironment,
        node: nodes.Element,
        is_ref: bool,
    ) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        if GLOSSARY in env.found_docs:
            env.note_dependency(env.doc2path(GLOSSARY))
        name = node["reftarget"]
        seen: tuple[str, ...] = env.temp_data.get(_SEEN) or ()
        if slug_of(env.docname) is None or name.lower() in seen:
            return [node], []
        env.temp_data[_SEEN] = (*seen, name.lower())
        anchor = nodes.make_id(f"term {name}")
        index = addnodes.index(entries=[("single", name, anchor, "", None)])
        return [index, nodes.target("", "", ids=[anchor]), node], []


def _items(env: BuildEnvironment) -> Iterator[nodes.definition_list_item]:
    if GLOSSARY in env.found_docs:
        for glossary in env.get_doctree(GLOSSARY).findall(addnodes.glossary):
            yield from glossary.findall(nodes.definition_list_item)


def _lessons(item: nodes.Element) -> Iterator[str]:
    for link in item.findall(addnodes.pending_xref):
        page = link["reftarget"].lstrip("/")
        if link["reftype"] == "doc" and page.startswith("chapters/"):
            yield page


def find_places(env: BuildEnvironment) -> dict[str, Place]:
    """Every name of the glossary, in small letters."""
    entries = env.domains.index_domain.entries
    found: dict[str, Place] = {}
    for item in _items(env):
        names = tuple(term.astext() for term in item.findall(nodes.term))
        lower = {name.lower() for name in names}
        place = next(
            (
                Place(names, page, anchor)
                for page in _lessons(item)
                for _, value, anchor, _, _ in entries.get(page, [])
                if value.lower() in lower
            ),
            Place(names, "", ""),
        )
        found |= dict.fromkeys(lower, place)
    return found


def marked(places: dict[str, Place], page: str, entries: list[Entry]) -> list[Entry]:
    """The entries of a page: those of the place that teaches a term come first, under all names."""
    made: list[Entry] = []
    for kind, text, anchor, main, key in entries:
        value = text.replace("'", "’")
        place = places.get(value.lower()) if kind == "single" else None
        if place is None:
            made.append((kind, value, anchor, main, key))
        elif (page, anchor) == (place.page, place.anchor):
            made += [(kind, name, anchor, "main", key) for name in place.names]
        elif page == GLOSSARY:
            made.append((kind, value, anchor, "" if place.page else "main", key))
        else:
            made.append((kind, value, anchor, "", key))
    return list(dict.fromkeys(made))


def keep_search_entries(env: BuildEnvironment) -> None:
    """Sphinx 8.2 forgets the index's entries of pages that it does not write again."""
    kept = env._search_index_index_entries
    for page, entries in env.domains.index_domain.entries.items():
        if "nosearch" not in env.metadata[page]:
            kept[page] = sorted(
                {
                    (word, anchor or "", main)
                    for kind, value, anchor, main, _ in entries
                    for word in split_index_msg(kind, value)
                }
            )


def mark_index(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Runs when all pages are read. The pages whose entries change are written again."""
    places = find_places(env)
    setattr(env, _PLACES, places)
    entries = env.domains.index_domain.entries
    changed = []
    for page in sorted(entries):
        now = marked(places, page, entries[page])
        if now != entries[page]:
            entries[page] = now
            changed.append(page)
    keep_search_entries(env)
    return changed


class MarkTerms(SphinxPostTransform):
    """What the search reads are the index's marks in a page."""

    default_priority = 5

    def run(self, **kwargs: object) -> None:
        places: dict[str, Place] = getattr(self.env, _PLACES, {})
        for node in self.document.findall(addnodes.index):
            node["entries"] = marked(places, self.env.docname, node["entries"])


class AddDefinitions(SphinxPostTransform):
    """Puts the definitions of the terms that a page links to at its end, for book.js to show."""

    # Before references are resolved, so that those of the definitions are, too.
    default_priority = 5
    formats = ("html",)

    def run(self, **kwargs: object) -> None:
        if self.env.docname == GLOSSARY or self.app.builder.name == "epub":
            return
        linked = {
            link["reftarget"].lower()
            for link in self.document.findall(addnodes.pending_xref)
            if link["reftype"] == "term"
        }
        section = next(iter(self.document.findall(nodes.section)), None)
        if not linked or section is None:
            return
        box = make_component("definitions", {})
        for item in _items(self.env):
            names = [term.astext() for term in item.findall(nodes.term)]
            if linked.isdisjoint(name.lower() for name in names):
                continue
            box += make_component(
                "definition",
                {"ids": [term["ids"][0] for term in item.findall(nodes.term)], "names": names},
                [make_slot("words", self.words(item))],
            )
        section += box

    def words(self, item: nodes.Element) -> list[nodes.Node]:
        [definition] = item.findall(nodes.definition)
        copied = definition.deepcopy()
        for link in copied.findall(addnodes.pending_xref):
            link["refdoc"] = self.env.docname
        # They are the glossary's words, which the search finds there.
        box = nodes.container(classes=["no-search"])
        box += copied.children
        return [box]


@renders("definitions")
def definitions_html(translator: HTML5Translator, node: component) -> str:
    made = "".join(
        definition_html(translator, child) for child in node if isinstance(child, component)
    )
    return f'<div class="definitions" hidden>{made}</div>\n'


@renders("definition")
def definition_html(translator: HTML5Translator, node: component) -> str:
    first, *others = node["data"]["names"]
    also = f'<p class="also">Also: {", ".join(others)}</p>' if others else ""
    where = attributes(**{"data-terms": " ".join(node["data"]["ids"])})
    words = slots(translator, node)["words"][0]
    return f'<div class="definition"{where}><p class="name">{first}</p>{words}{also}</div>'


def connect(app: Sphinx) -> None:
    app.add_role_to_domain("std", "term", TermRole(), override=True)
    app.add_post_transform(MarkTerms)
    app.add_post_transform(AddDefinitions)
    app.connect("env-updated", mark_index)
