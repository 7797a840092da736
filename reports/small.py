"""What a page of tables can be written without, so that a report of many cases stays a file one can send.

Tables stand in the templates as anyone would write them; here, when the page is whole, a column of numbers says so once
for the table instead of once in every cell, and tags and quotes go that HTML does not ask for; quotes in figures, too.
"""

import re

_MOST_COLUMNS = 24  # counted from the last; the style sheet has a rule for each
# The rule weighs as much as that of .num, so that other rules stand above the two alike.
STYLES = "".join(
    f":where(.n{k} tbody tr)>:nth-last-child({k}){','*(k < _MOST_COLUMNS)}" for k in range(1, _MOST_COLUMNS + 1)
) + "{text-align:right;white-space:nowrap}"


def page(source):
    """The page with its tables and what is in its figures written short."""
    source = re.sub(r"<table.*?</table>", lambda table: _bare(_numbers(table.group(0))), source, flags=re.DOTALL)
    return re.sub(r'(<svg class="pl"[^>]*>)(.*?</svg>)', lambda figure: figure[1] + _unquoted(figure[2]), source, flags=re.DOTALL)


def _numbers(table):
    """The table with class="num" taken from the cells of columns, counted from the last, that hold nothing else."""
    bodies = re.findall(r"<tbody.*?</tbody>", table, flags=re.DOTALL)
    rows = [re.findall(r"<t[dh]\b[^>]*>", row) for body in bodies for row in re.split(r"<tr\b", body)[1:]]
    columns = [
        k
        for k in range(1, _MOST_COLUMNS + 1)
        if any(len(row) >= k for row in rows) and all(len(row) < k or _is_number(row[-k]) for row in rows)
    ]
    if not columns:
        return table
    body = re.compile(r"<tbody.*?</tbody>", re.DOTALL)
    table = body.sub(lambda found: _without_class(found.group(0), columns), table)
    named = " ".join(f"n{k}" for k in columns)
    opening = re.match(r"<table\b[^>]*>", table).group(0)
    if 'class="' in opening:
        shorter = opening.replace('class="', f'class="{named} ', 1)
    else:
        shorter = opening.replace("<table", f'<table class="{named}"', 1)
    return shorter + table[len(opening) :]


def _is_number(cell):
    return bool(re.search(r'class="(?:[^"]* )?num(?: [^"]*)?"', cell))


def _without_class(body, columns):
    def row(found):
        cells = re.split(r"(<t[dh]\b[^>]*>)", found.group(0))
        for k in columns:
            place = len(cells) - 2 * k
            if place > 0:
                cells[place] = cells[place].replace(' class="num"', "", 1)
        return "".join(cells)

    return re.sub(r"<tr\b.*?(?=<tr\b|</tbody>)", row, body, flags=re.DOTALL)


def _bare(table):
    parts = re.split(r"(<svg .*?</svg>|<pre.*?</pre>)", table, flags=re.DOTALL)
    for index in range(0, len(parts), 2):
        short = re.sub(r"</(?:td|th|tr|tbody|thead)>\s*(?=<(?:td|th|tr|tbody|thead|/table|/tr|/tbody|/thead)\b)", "", parts[index])
        parts[index] = _unquoted(short)
    return "".join(parts)


def _unquoted(source):
    """Values without quotes where they need none; before the end of an empty element they do."""
    return re.sub(r"<\w[^<>]*>", lambda tag: re.sub(r'="([A-Za-z0-9_.:#%-]+)"(?=[\s>])', r"=\1", tag[0]), source)
