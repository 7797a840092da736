"""The words of all pages and the places where they stand, for the search: a script that the pages load when it is asked for.

A place is whatever a link can lead to: a heading, a case, a gate, a figure. Its words are those up to the next place.
Numbers are no words; a name such as density.L1 is found whole and by its parts.
"""

import html
import json
import re
import unicodedata

_SKIPPED = re.compile(r"<(style|script|nav)\b.*?</\1>|<svg class=\"?symbols.*?</svg>", re.DOTALL)
_TAG = re.compile(r"<(/?)([a-z][\w-]*)([^<>]*)>|([^<]+)", re.DOTALL)
_ATTRIBUTE = re.compile(r'([\w-]+)=(?:"([^"]*)"|\'([^\']*)\'|([^\s>]+))')
_WORD = re.compile(r"[^\W_](?:[\w.+'’-]*[^\W_])?")
_PART = re.compile(r"[^\W_]+")
_MOST_TITLE = 90  # characters
_PLACES = re.compile(r"h[1-4]|tr|svg|figure|section|article|details|td|header|ul|table|div")
_TITLES = re.compile(r"h[1-4]|th|summary|caption")  # and class plot-title: the first of a place is its title


class Place:
    def __init__(self, page, name=""):
        self.page, self.name, self.title, self.words = page, name, "", set()


def script(sources, titles):
    """The script that hands the index over; `sources` and `titles`: of each page by its path."""
    paths = list(sources)
    places = [place for number, path in enumerate(paths) for place in places_of(sources[path], number)]
    at = {}
    for number, place in enumerate(places):
        for word in place.words:
            at.setdefault(word, []).append(number)
    index = {
        "pages": [[path, titles[path]] for path in paths],
        "places": [[place.page, place.name, place.title] for place in places],
        "words": {word: _steps(numbers) for word, numbers in sorted(at.items())},
    }
    return f"plumblineSearch.take({json.dumps(index, ensure_ascii=False, separators=(',', ':'))});\n"


def _steps(numbers):
    """Rising numbers by their differences, in base 36."""
    return " ".join(_base36(number - before) for before, number in zip([0, *numbers], numbers))


def _base36(number):
    digits = ""
    while number or not digits:
        number, digit = divmod(number, 36)
        digits = "0123456789abcdefghijklmnopqrstuvwxyz"[digit] + digits
    return digits


def places_of(source, page):
    """The places of a page in their order, each with its words."""
    place = Place(page)
    found, title, drawing = [place], None, 0
    for closing, tag, attributes, text in _TAG.findall(_SKIPPED.sub(" ", source)):
        if text:
            if not drawing:
                words = html.unescape(text)
                place.words |= words_of(words)
                if title is not None:
                    title.append(words)
            continue
        if tag == "svg":
            drawing = 0 if closing else drawing + 1
        if closing:
            if title is not None and _TITLES.fullmatch(tag) or tag == "div" and title is not None:
                place.title = place.title or " ".join("".join(title).split())[:_MOST_TITLE]
                title = None
            continue
        given = {name: html.unescape(a or b or c) for name, a, b, c in _ATTRIBUTE.findall(attributes)}
        name = given.get("id", "")
        if tag == "figure":
            place = Place(page)
            found.append(place)
        elif tag == "svg" and name and "pl" in given.get("class", "").split() and not place.name:
            place.name = name
            place.words |= words_of(given.get("aria-label", ""))
        elif name and _PLACES.fullmatch(tag) and tag != "svg":
            place = Place(page, name)
            found.append(place)
        if _TITLES.fullmatch(tag) or given.get("class") == "plot-title":
            title = []
    return [place for place in found if place.name or place.words]


def words_of(text):
    """The words of a text as they are compared: small letters without marks."""
    plain = "".join(letter for letter in unicodedata.normalize("NFD", text.lower()) if not unicodedata.combining(letter))
    whole = {word for word in _WORD.findall(plain)}
    parts = {part for word in whole for part in _PART.findall(word)}
    return {word for word in whole | parts if 1 < len(word) < 60 and not re.fullmatch(r"[\d.+\-e×]*", word)}
