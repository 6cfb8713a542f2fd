"""do_page.py PAGE: does in this folder what a page shows, in its order: files that it has are written, Python and lines that call
stepwire are run. Anything that fails ends it."""

import pathlib
import re
import subprocess
import sys
from typing import Any


def done(fence, lead, names):
    language, text = fence
    if language in ("yaml", "csv"):
        name = re.findall(r"`([\w-]+\.(?:yaml|csv))`", lead)[0]
        pathlib.Path(name).write_text(text)
    elif language == "python":
        exec(compile(text, "page", "exec"), names)
    elif language == "sh":
        for line in text.splitlines():
            if line.startswith("stepwire "):
                subprocess.run(line, shell=True, check=True)


names: dict[str, Any] = {}
fences = re.findall(r"((?:[^\n]+\n)*)\n```(\w+)\n(.*?)```", pathlib.Path(sys.argv[1]).read_text(), re.DOTALL)
for lead, language, text in fences:
    done((language, text), lead, names)
fit = names["fit"]
low, high = fit.parameters["tau"].interval
assert fit.converged and low < 25 * 60 < high, (low, high)
assert all(claim.holds or claim.disagrees for claim in names["push"].claims) and "<svg" in names["push"].figures[0].svg
assert all(pathlib.Path(f"fig15/figure.{kind}").stat().st_size > 1000 for kind in ("svg", "png", "pdf"))
