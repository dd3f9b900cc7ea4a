"""A report as a single HTML file that needs no network: a template of this folder, filled in."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import jinja2

from core.files.whole_file import write_whole
from core.words.wording import Wording


def write_html(file: Path, template: str, content: Mapping[str, Any], words: Wording) -> None:
    """Writes the page; the file appears complete or not at all, and replaces an older one of the same name.

    Args:
        template: name of a file beside this one; `style.css` is included by all.
        content: everything that the template names, but for `say`, which gives it a message of the catalogue, and `language`.
        words: of the page.

    Raises:
        jinja2.UndefinedError: the template names what `content` lacks.
    """
    templates = jinja2.FileSystemLoader(Path(__file__).parent)
    environment = jinja2.Environment(loader=templates, autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True)
    text = environment.get_template(template).render(content, say=words.say, language=words.language)
    write_whole(file, text)
