"""`{scene-player}`: scenes to pick and to run in the page, over a picture of the first of them.

The page opens with that scene, moving; page/web/build.mjs draws its picture.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.writers.html5 import HTML5Translator

from contact_book.directive import BookDirective
from contact_book.errors import BookError, unknown
from contact_book.html import attributes, base_path, can_run_scripts, json_script, renders, slots
from contact_book.live_figure import size_of
from contact_book.nodes import component, make_component, make_slot


def scenes_of(folder: Path) -> list[dict[str, str]]:
    """The name and the sentence of every scene of a chapter, by name."""
    found = []
    for path in sorted(folder.glob("*.json")):
        scene = json.loads(path.read_text(encoding="utf-8"))
        found.append({"name": path.stem, "about": str(scene["about"])})
    return found


class ScenePlayer(BookDirective):
    """The argument is the chapter whose scenes it plays; by default the current chapter.

    `:first:` names the scene that the page opens with; by default the first by name.
    """

    optional_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Any]] = {"first": directives.unchanged_required}

    def build(self) -> list[nodes.Node]:
        slug = self.arguments[0].strip() if self.arguments else self.here
        if slug is None:
            raise BookError("scene-player needs a chapter here, as in {scene-player} 20_scenes")
        folder = self.book.chapter(slug, self.source).folder / "scenes"
        scenes = scenes_of(folder)
        if not scenes:
            raise BookError(f"chapters/{slug}/scenes has no scene")
        names = [each["name"] for each in scenes]
        first = self.options.get("first", names[0]).strip()
        if first not in names:
            raise unknown("scene", first, names, f"{self.source}, :first:")
        built = Path(self.config.contact_web) / "scenes"
        picture, facts = built / "first.svg", built / "first.json"
        self.depends(picture, facts, folder, *(folder / f"{each['name']}.json" for each in scenes))
        self.needs_script()
        data: dict[str, Any] = {
            "slug": slug,
            "scenes": scenes,
            "first": first,
            "describe": "",
            "size": None,
        }
        if facts.is_file() and picture.is_file():
            drawn = json.loads(facts.read_text(encoding="utf-8"))
            if drawn["first"] != first:
                raise BookError(
                    f"the page opens with {first}, but its picture is of {drawn['first']}: "
                    "change :first:, or the scene that page/web/build.mjs draws"
                )
            data["describe"] = drawn["describe"]
            data["size"] = size_of(picture)
        else:
            self.missing_figure(f"the picture of the scene player is not built: {picture}")
        caption: list[nodes.Node] = []
        if self.content:
            caption = self.inline_markdown("\n".join(self.content))
        return [make_component("scene-player", data, [make_slot("caption", caption)])]


@renders("scene-player")
def scene_player_html(translator: HTML5Translator, node: component) -> str:
    data = node["data"]
    caption = "".join(slots(translator, node)["caption"])
    base = base_path(translator)
    if data["size"]:
        width, height = data["size"]
        source = f"{base}scenes/first.svg"
        inner = f"<img{attributes(src=source, alt=data['describe'], width=width, height=height)}/>"
    else:
        inner = '<p class="not-built">The scene player is still being built.</p>'
    command = f"./contact simulate {data['first']}"
    offered = (
        f'<p class="unplayed">The {len(data["scenes"])} scenes of the book run here in a browser '
        f"with scripts. From the command line: <code>{command}</code></p>"
    )
    if can_run_scripts(translator):
        listed = json_script({"first": data["first"], "scenes": data["scenes"]})
        where = attributes(name=data["slug"], base=base)
        inner = (
            f"<contact-player{where}>{listed}{inner}<noscript>{offered}</noscript></contact-player>"
        )
    else:
        inner += offered
    words = f"<figcaption>{caption}</figcaption>" if caption else ""
    return f'<figure class="live">{inner}{words}</figure>\n'
