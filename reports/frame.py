"""What every page of the report is made with: templates, styles, scripts, and files that are there whole or not at all."""

import functools
import os
import pathlib
import platform

import jinja2

import compact
import libraries
import small
import svg
import tables
import text

HERE = pathlib.Path(__file__).resolve().parent
SHARED_STYLES = "/* styles of the drawings */"  # where compact.py puts them
SCRIPTS = ("theme", "figures", "page", "search")


def page(template, more_style="", beside=None, **shown):
    """The text of a page; `more_style`: rules of its own.

    It holds all it needs, or, where `beside` is the way from it to the folder of `shared_files`, has these from there.
    """
    own = more_style if beside is not None else style_sheet(more_style)
    style = markup("\n".join((own, SHARED_STYLES)))
    source = environment().get_template(template).render(style=style, scripts=scripts(), beside=beside, **shown)
    source, rules = compact.with_shared_styles(source)
    return small.page(source.replace(SHARED_STYLES, rules, 1))


@functools.cache
def environment():
    made = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE / "templates"),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.ChainableUndefined,
    )
    made.filters.update(plural=text.plural, by_label=tables.by_label, by_reason=tables.by_reason, identity_matrix=tables.identity_matrix, prose=text.prose)
    made.globals.update(series_mark=svg.series_mark)
    return made


def shared_files():
    """{name: text} of what the pages of a folder share."""
    return {
        "style.css": style_sheet(),
        **{f"{name}.js": str(scripts()[name]) for name in (*SCRIPTS, "library") if scripts()[name]},
    }


@functools.cache
def style_sheet(more=""):
    """All rules of the page; those of the dark page stand for the preference of the reader and for the switch."""
    style, dark = ((HERE / "templates" / name).read_text(encoding="utf-8") for name in ("style.css", "dark.css"))
    dark = (
        f"@media screen and (prefers-color-scheme: dark) {{ :root:not([data-theme=light]) {{ {dark} color-scheme: dark; }} }}\n"
        f"@media screen {{ :root[data-theme=dark] {{ {dark} color-scheme: dark; }} :root[data-theme=light] {{ color-scheme: light; }} }}"
    )
    return "\n".join((style, dark, small.STYLES, more))


def scripts():
    """The scripts of the page by name, and what is said of the library among them."""
    library, words = libraries.zoom()
    own = {name: (HERE / "scripts" / f"{name}.js").read_text(encoding="utf-8") for name in SCRIPTS}
    return {**{name: markup(script) for name, script in own.items()}, "library": markup(library), "words": words}


def ready(parts, *commands):
    """The figures that could be drawn, their drawings marked as checked markup; `commands`: what makes the numbers of those that name none."""
    found = [figure for figure in parts if figure]
    for figure in found:
        figure.svg = markup(figure.svg)
        figure.commands = figure.commands or [command for command in commands if command]
    return found


def markup(checked):
    return jinja2.utils.markupsafe.Markup(checked)


def write_whole(path, content):
    """Under a temporary name first, so that a page is there whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    remove_abandoned(path)
    temporary = path.with_name(f"{path.name}.{platform.node()}-{os.getpid()}.part")
    try:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def remove_abandoned(path):
    """What processes of this machine that were killed as they wrote the page left beside it."""
    for part in path.parent.glob(f"{path.name}.{platform.node()}-*.part"):
        try:
            os.kill(int(part.name.split("-")[-1].removesuffix(".part")), 0)
        except ProcessLookupError:
            part.unlink(missing_ok=True)
        except (PermissionError, ValueError):
            pass
