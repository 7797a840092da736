"""Equations as MathML, which browsers draw without script, font or network: KaTeX translates them when the site is made.

An equation of its own that ends in `\\tag{York 3.15}` bears the source and number by which `ci/check_equations` knows it.
"""

import json
import re
import subprocess

from docutils import nodes
from sphinx.errors import ExtensionError

KATEX = "/usr/share/javascript/katex/katex.js"  # of the package libjs-katex
TAG = re.compile(r"\\tag\{([^}]*)\}")
ACCENT = re.compile(r"<mover accent=\"true\"><mi>(.)</mi><mo[^>]*>([~˙ˉ])</mo></mover>")
COMBINING = {"~": "\u0303", "˙": "\u0307", "ˉ": "\u0304"}  # over one letter these stand better than an operator above it, whatever the font
TRANSLATE = """
const katex = require(process.argv[1]);
require("readline").createInterface({input: process.stdin}).on("line", line => {
  const {tex, display} = JSON.parse(line);
  let answer;
  try { answer = {mathml: katex.renderToString(tex, {displayMode: display, output: "mathml", strict: "error"})}; }
  catch (error) { answer = {error: error.message}; }
  console.log(JSON.stringify(answer));
});
"""


class Translator:
    """One process of node that answers each equation with a line."""

    def __init__(self):
        self._node = subprocess.Popen(["node", "-e", TRANSLATE, KATEX], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8")

    def mathml(self, tex, display):
        self._node.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self._node.stdin.flush()
        answer = json.loads(self._node.stdout.readline() or '{"error": "node has ended"}')
        if "error" in answer:
            raise ExtensionError(f"the equation {tex!r} is not understood: {answer['error']}")
        return ACCENT.sub(lambda match: f"<mi>{match[1]}{COMBINING[match[2]]}</mi>", answer["mathml"])

    def end(self, *_):
        self._node.communicate()


def setup(app):
    translator = Translator()

    def inline(writer, node):
        writer.body.append(translator.mathml(node.astext(), False))
        raise nodes.SkipNode

    def displayed(writer, node):
        tex = node.astext()
        tags = "; ".join(TAG.findall(tex))
        writer.body.append(f'<div class="equation" tabindex="0">{translator.mathml(TAG.sub("", tex), True)}')
        writer.body.append(f'<span class="tag">[{tags}]</span></div>\n' if tags else "</div>\n")
        raise nodes.SkipNode

    app.add_html_math_renderer("mathml", inline_renderers=(inline, None), block_renderers=(displayed, None))
    app.connect("build-finished", translator.end)
    return {"parallel_read_safe": True}
