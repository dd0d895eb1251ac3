"""Volume, centroid and inertia of the solids of the STEP files here, by OpenCASCADE.

Writes solids.json beside this file. Independent of Lanchester: the files are opened by gmsh's OpenCASCADE kernel, which
checks and integrates them; the density is 1, lengths are millimetres as the files say.
"""

import json
from pathlib import Path

import gmsh

HERE = Path(__file__).parent
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
# Solids that touch must stay apart, and nothing may be mended.
for option in ["OCCFixDegenerated", "OCCFixSmallEdges", "OCCFixSmallFaces", "OCCSewFaces", "OCCMakeSolids"]:
    gmsh.option.setNumber(f"Geometry.{option}", 0)
gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
gmsh.logger.start()

files = {}
for path in sorted(HERE.glob("*.step")):
    gmsh.clear()
    found = gmsh.model.occ.importShapes(str(path), highestDimOnly=True)
    gmsh.model.occ.synchronize()
    solids = []
    for dim, tag in found:
        assert dim == 3, f"{path.name}: a shape of dimension {dim} is no solid"
        kinds = {}
        for _, face in gmsh.model.getBoundary([(dim, tag)], oriented=False):
            kind = gmsh.model.getType(2, face)
            kinds[kind] = kinds.get(kind, 0) + 1
        inertia = gmsh.model.occ.getMatrixOfInertia(dim, tag)
        solids.append(
            {
                # The name of the solid, behind those of the shape representation.
                "name": gmsh.model.getEntityName(dim, tag).split("/")[-1],
                "faces": kinds,
                "volume [mm3]": gmsh.model.occ.getMass(dim, tag),
                "centroid [mm]": list(gmsh.model.occ.getCenterOfMass(dim, tag)),
                "inertia about the centroid [mm5]": [list(inertia[3 * i : 3 * i + 3]) for i in range(3)],
            }
        )
    files[path.name] = solids
warnings = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
assert not warnings, warnings

details = gmsh.option.getString("General.BuildInfo").split("; ")
kernel = next(part.split(": ")[1] for part in details if part.startswith("OCC version"))
answer = {"tool": f"gmsh {gmsh.__version__}, OpenCASCADE {kernel}", "files": files}
(HERE / "solids.json").write_text(json.dumps(answer, indent=1) + "\n")
