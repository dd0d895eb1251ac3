"""Runs ccx on the decks in this folder and writes what it says to results.json."""
import json, re, shutil, subprocess, tempfile
from pathlib import Path

# Of so many nodes one in EACH is kept.
MANY, EACH = 1000, 50
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
        displacements = rows(text, "displacements")
        case = {"energy_mJ": rows(text, "total internal energy")[0][0]}
        if len(displacements) < MANY:
            case["displacements_mm"] = [row[1:] for row in displacements]
            case["stresses_MPa_first_element"] = [row[2:] for row in rows(text, "stresses") if row[0] == 1.0]
        else:
            # Number of the node and its displacement, for some of the nodes; the largest of all.
            case["some_displacements_mm"] = displacements[::EACH]
            case["largest_displacement_mm"] = max(sum(u * u for u in row[1:]) ** 0.5 for row in displacements)
    else:
        case = {"frequencies_Hz": [row[3] for row in rows(text, "MODE NO    EIGENVALUE")]}
    out["cases"][deck.stem] = case
(here / "results.json").write_text(json.dumps(out) + "\n")
