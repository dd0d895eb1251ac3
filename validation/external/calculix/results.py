"""Runs ccx on the decks in this folder and writes what it says to results.json."""
import json, re, shutil, subprocess, tempfile
from pathlib import Path

here = Path(__file__).parent
out = {"program": "CalculiX ccx 2.20 (Debian 12, calculix-ccx 2.20-1)", "cases": {}}


def rows(text, head):
    """Lines of numbers after the line that begins with `head`."""
    found, on = [], False
    for line in text.splitlines():
        if line.strip().startswith(head):
            on = True
        elif on and re.match(r"\s*[-\d]", line):
            found.append([float(x) for x in line.split()])
        elif on and found and line.strip():
            on = False
    return found


for deck in sorted(here.glob("*.inp")):
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(deck, folder)
        subprocess.run(["ccx", "-i", deck.stem], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        text = (Path(folder) / f"{deck.stem}.dat").read_text()
    if "static" in deck.stem:
        case = {
            "energy_mJ": rows(text, "total internal energy")[0][0],
            "displacements_mm": [row[1:] for row in rows(text, "displacements")],
            "stresses_MPa_first_element": [row[2:] for row in rows(text, "stresses") if row[0] == 1.0],
        }
    else:
        case = {"frequencies_Hz": [row[3] for row in rows(text, "MODE NO    EIGENVALUE")]}
    out["cases"][deck.stem] = case
(here / "results.json").write_text(json.dumps(out) + "\n")
