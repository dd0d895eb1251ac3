"""Writes python/lanchester/results.py: a class for every structure of every result, from the JSON Schemas of the Rust types.

`python generate.py` prints it; the installed package `lanchester._native` gives the schemas. `cargo xtask python --write` puts it in its place.
"""

from __future__ import annotations

import importlib.machinery
import importlib.util
import json
import keyword
import re
import sys
from pathlib import Path
from typing import Any

HEAD = '''"""Types of all results: a class for every structure, with its fields, units and meanings.

Written by `cargo xtask python --write` from the Rust types. Do not edit. SI units and radians; complex numbers are rows of real and imaginary part.
"""

# ruff: noqa

from __future__ import annotations

from typing import Any, Literal

from ._record import FloatArray, Record, Records, Result

'''

# What types are written with.
BUILTIN = {"bool", "dict", "float", "int", "list", "str"}

# What every result has beside its fields.
TAKEN = {"to_dict", "to_json", "to_text", "to_dataframe", "pick", "tables", "table", "figures", "plot", "adopt"}


class Types:
    """The definitions and what Python makes of them."""

    def __init__(self, definitions: dict[str, Any], results: set[str]) -> None:
        self.definitions = definitions
        self.results = results

    def merged(self, schema: dict[str, Any]) -> dict[str, Any] | None:
        """The properties of a structure: those of all variants of a tagged union together; None where it is no structure."""
        schema = dict(schema)
        found: dict[str, Any] = {}
        if "$ref" in schema:
            below = self.merged(self.definitions[name_of(schema)])
            if below is None or not (set(schema) - {"$ref", "description", "type"} or below):
                return None
            found.update(below)
        for own in schema.get("allOf", []):
            below = self.merged(own)
            if below is None:
                return None
            found.update(below)
        for union in ("oneOf", "anyOf"):
            if union in schema:
                variants = [self.merged(own) for own in schema[union]]
                if any(variant is None for variant in variants):
                    return None
                if "properties" not in schema and not tag_of(variants):
                    return None
                known = [variant for variant in variants if variant is not None]
                for variant in known:
                    for name, (of, _) in variant.items():
                        everywhere = all(name in other and other[name][1] for other in known)
                        if name in found and "const" in found[name][0] | of:
                            words = [*words_of(found[name][0]), *words_of(of)]
                            doc = "Which of the variants it is."
                            of = {"enum": list(dict.fromkeys(words)), "description": doc}
                        elif "const" in of:
                            of = {**of, "description": "Which of the variants it is."}
                        found[name] = (of, everywhere)
        if "properties" in schema:
            required = schema.get("required", [])
            found.update({name: (of if isinstance(of, dict) else {}, name in required) for name, of in schema["properties"].items()})
        elif not found:
            return None
        return found

    def kind(self, schema: Any) -> tuple[str, str]:
        """How a field is read (`get`, `array`, `list`, `of`, `all`), and its type."""
        if not isinstance(schema, dict):
            return "get", "Any"
        if "anyOf" in schema and len(schema["anyOf"]) == 2 and {"type": "null"} in schema["anyOf"]:
            [own] = [own for own in schema["anyOf"] if own != {"type": "null"}]
            how, of_own = self.kind(own)
            return how, optional(of_own)
        if "$ref" in schema and set(schema) <= {"$ref", "description", "default"}:
            name = name_of(schema)
            if self.merged(self.definitions[name]) is not None:
                return "of", python_name(name)
            return self.kind(self.definitions[name])
        if "const" in schema:
            return "get", f"Literal[{schema['const']!r}]"
        if "enum" in schema:
            words = ", ".join(repr(word) for word in schema["enum"] if word is not None)
            return "get", optional(f"Literal[{words}]") if None in schema["enum"] else f"Literal[{words}]"
        if "oneOf" in schema or "anyOf" in schema:
            choices = schema["oneOf"] if "oneOf" in schema else schema["anyOf"]
            return "get", union([self.kind(choice)[1] for choice in choices])
        kind = schema.get("type")
        if isinstance(kind, list):
            rest = [own for own in kind if own != "null"]
            how, own = self.kind({**schema, "type": rest[0] if len(rest) == 1 else None})
            return how, optional(own) if "null" in kind else own
        plain = {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None"}
        if kind in plain:
            return "get", plain[kind]
        if kind == "array":
            return self.array(schema)
        if kind == "object":
            below = schema.get("additionalProperties")
            return "get", f"dict[str, {self.kind(below)[1] if below else 'Any'}]"
        return "get", "Any"

    def array(self, schema: dict[str, Any]) -> tuple[str, str]:
        if "prefixItems" in schema:
            kinds = [self.kind(own)[1] for own in schema["prefixItems"]]
            if set(kinds) <= {"float"}:
                return "array", "FloatArray"
            if set(kinds) <= {"FloatArray"}:
                return "array", "FloatArray"
            return "list", "list[Any]"
        how, kind = self.kind(schema.get("items"))
        if kind == "float":
            return "array", "FloatArray"
        if kind == "FloatArray":
            # Rows of one length are an array of two dimensions.
            return ("array", "FloatArray") if is_fixed(schema["items"]) else ("rows", "list[FloatArray]")
        if how == "of" and not kind.endswith("| None"):
            return "all", f"Records[{kind}]"
        if kind.startswith("Records[") or how == "of":
            kind = "dict[str, Any]" if how == "of" else "list[dict[str, Any]]"
        return "list", f"list[{kind}]"


def is_fixed(schema: Any) -> bool:
    """Whether every list of this schema is of one length."""
    return "prefixItems" in schema or schema.get("minItems", 0) == schema.get("maxItems", -1)


def words_of(schema: dict[str, Any]) -> list[Any]:
    return [schema["const"]] if "const" in schema else list(schema.get("enum", []))


def tag_of(variants: list[dict[str, Any] | None]) -> bool:
    """Whether a field says which variant it is."""
    common = set.intersection(*(set(variant or {}) for variant in variants)) if variants else set()
    return any(all("const" in (variant or {})[name][0] or "enum" in (variant or {})[name][0] for variant in variants) for name in common)


def optional(kind: str) -> str:
    return kind if kind in ("Any", "None") or kind.endswith("| None") else f"{kind} | None"


def union(kinds: list[str]) -> str:
    literals = [word for kind in kinds if kind.startswith("Literal[") for word in [kind[8:-1]]]
    others = list(dict.fromkeys(kind for kind in kinds if not kind.startswith("Literal[")))
    if any("Any" == kind for kind in others):
        return "Any"
    return " | ".join([*([f"Literal[{', '.join(dict.fromkeys(literals))}]"] if literals else []), *others])


def name_of(schema: dict[str, Any]) -> str:
    return str(schema["$ref"]).rsplit("/", 1)[-1]


def python_name(name: str) -> str:
    return re.sub(r"\W", "", name)


def words(text: str | None) -> str:
    """Documentation of Rust as plain text."""
    text = re.sub(r"\[`(?:[\w:]+::)?(\w+(?:\(\))?)`\](?:\([^)]*\))?", r"`\1`", text or "")
    text = re.sub(r"^`\w+_VERSION`\.$", "Version of this structure.", text)
    text = text.replace("\\", "\\\\").replace('"""', "'''").strip()
    return "\n".join(line.rstrip() for line in text.splitlines())


def doc(text: str, indent: str) -> str:
    lines = words(text).splitlines() or ["Not described."]
    quoted = ("\n" + indent).join(lines).replace("\n" + indent + "\n", "\n\n")
    end = "\n" + indent if len(lines) > 1 else ""
    if not end and quoted.endswith('"'):
        end = " "
    return f'{indent}"""{quoted}{end}"""\n'


def write(schemas: dict[str, Any]) -> str:
    definitions = json.loads(schemas["definitions"])
    results = set(schemas["questions"].values())
    types = Types(definitions, results)
    structures = {name: properties for name in sorted(definitions) if (properties := types.merged(definitions[name])) is not None}
    out = HEAD
    out += "__all__ = [\n" + "".join(f"    {python_name(name)!r},\n" for name in structures).replace("'", '"') + "]\n"
    for name, properties in structures.items():
        base = "Result" if name in results else "Record"
        out += f"\n\nclass {python_name(name)}({base}):\n" + doc(definitions[name].get("description", ""), "    ")
        fields = {own: own.replace("-", "_") + ("_" if keyword.iskeyword(own) or own in BUILTIN else "") for own in properties}
        clash = TAKEN.intersection(fields.values()) if base == "Result" else set()
        if clash:
            sys.exit(f"{name} has a field {clash.pop()}, which every result has as a method: rename one of them")
        out += "\n    __slots__ = ()\n"
        out += "    _FIELDS = (" + "".join(f'"{own}", ' for own in fields.values()).rstrip(" ") + ")\n"
        for raw, own in fields.items():
            schema, required = properties[raw]
            how, kind = types.kind(schema)
            if not required and how in ("get", "of"):
                kind = optional(kind)
            if how == "of":
                body = f'self._of("{raw}", {kind.removesuffix(" | None")})'
            elif how == "all":
                body = f'self._all("{raw}", {kind[8:].split("]")[0]})'
            else:
                # What may be left out is None, not an empty list.
                own_how = "get" if how == "list" and kind.endswith("| None") else how
                body = f'self._{own_how}("{raw}")'
            out += f"\n    @property\n    def {own}(self) -> {kind}:\n" + doc(field_doc(schema, definitions), "        ")
            out += f"        return {body}  # type: ignore[no-any-return]\n" if how != "all" else f"        return {body}\n"
    return out


def field_doc(schema: Any, definitions: dict[str, Any]) -> str:
    if not isinstance(schema, dict):
        return "Any value."
    if "description" in schema:
        return str(schema["description"])
    for own in [schema, *schema.get("anyOf", [])]:
        if "$ref" in own:
            return str(definitions[name_of(own)].get("description", ""))
    return ""


def native() -> Any:
    """The compiled module alone: the package itself needs the types that are written here."""
    package = importlib.util.find_spec("lanchester")
    folders = list(package.submodule_search_locations or []) if package else []
    for folder in folders:
        for path in Path(folder).glob("_native*"):
            if path.suffix in (".so", ".pyd"):
                loader = importlib.machinery.ExtensionFileLoader("lanchester._native", str(path))
                spec = importlib.util.spec_from_file_location("lanchester._native", path, loader=loader)
                if spec is not None:
                    module = importlib.util.module_from_spec(spec)
                    loader.exec_module(module)
                    return module
    sys.exit("the package lanchester is not installed")


if __name__ == "__main__":
    sys.stdout.write(write(native().schemas()))
