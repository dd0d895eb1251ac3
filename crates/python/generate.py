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

from ._record import FloatArray, Matrices, Record, Records, Result, Variant, an_array, every, one, optionally, record, row

'''

# What types are written with.
BUILTIN = {"bool", "dict", "float", "int", "list", "str"}

# What every result has beside its fields.
TAKEN = {"to_dict", "to_json", "to_text", "to_dataframe", "pick", "tables", "table", "figures", "plot", "adopt"}

# Names of their own for what two crates call alike: the schemas number them.
NAMES = {
    "Audit2": "GraphAudit",
    "CrankUnbalance2": "CrankWithBobweights",
    "Outcome2": "IntegrationOutcome",
    "Quantity2": "VariedQuantity",
}

# Square matrices that are given row by row.
SQUARE = {"ReducedModel": {"stiffness", "mass", "gyroscopic", "centrifugal"}}


class Types:
    """The definitions and what Python makes of them."""

    def __init__(self, definitions: dict[str, Any], results: set[str]) -> None:
        self.definitions = definitions
        self.results = results
        # What is in a variant and has no name of its own.
        for name in sorted(definitions):
            for variant, content, _ in self.variants(definitions[name]) or []:
                if content is not None and "properties" in content:
                    below = python_name(name) + camel(variant)
                    if below in definitions:
                        sys.exit(f"{name} has the variant {variant}, and there is a structure {below}: give one of them another name")
                    [own] = [own for own in definitions[name]["oneOf"] if variant in own.get("properties", {})]
                    definitions[below] = {"description": own.get("description", f"What is in `{variant}`."), **content}
                    own["properties"][variant] = {"$ref": f"#/$defs/{below}"}

    def variants(self, schema: Any) -> list[tuple[str, dict[str, Any] | None, str]] | None:
        """The variants of a union that names each by a word or by a key of its own: word, what is in it, and its meaning; None where it is no such union."""
        found: list[tuple[str, dict[str, Any] | None, str]] = []
        for own in schema.get("oneOf", []) if isinstance(schema, dict) else []:
            doc = own.get("description", "")
            properties = own.get("properties", {})
            if "const" in own or "enum" in own:
                found += [(str(word), None, doc) for word in words_of(own)]
            elif len(properties) == 1 and own.get("required") == list(properties) and own.get("additionalProperties") is False:
                [(word, content)] = properties.items()
                found.append((word, content, doc))
            else:
                return None
        return found if any(content is not None for _, content, _ in found) else None

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
            if self.variants(self.definitions[name]) is not None or self.merged(self.definitions[name]) is not None:
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
            return "as", f"tuple[{', '.join(kinds)}]"
        how, kind = self.kind(schema.get("items"))
        if kind == "float":
            return "array", "FloatArray"
        if kind == "FloatArray":
            # Rows of one length are an array of two dimensions.
            return ("array", "FloatArray") if is_fixed(schema["items"]) else ("rows", "list[FloatArray]")
        if how == "of" and not kind.endswith("| None"):
            return "all", f"Records[{kind}]"
        plain = how == "get" or (how == "list" and "FloatArray" not in kind)
        return "list" if plain else "as", f"list[{kind}]"

    def reader(self, schema: dict[str, Any]) -> str:
        """How a value of this schema is read, written in functions of `_record`."""
        how, kind = self.kind(schema)
        if how in ("get", "list"):
            return "one"
        if kind.endswith(" | None"):
            rest = [own for own in schema.get("anyOf", []) if own != {"type": "null"}]
            own = {**schema, "type": [kind for kind in schema["type"] if kind != "null"][0]} if not rest else rest[0]
            return f"optionally({self.reader(own)})"
        if how == "of":
            return kind
        if how == "array":
            return "an_array"
        if "$ref" in schema:
            return self.reader(self.definitions[name_of(schema)])
        if how == "all":
            return f"record({self.reader(schema['items'])})"
        if "prefixItems" in schema:
            return f"row({', '.join(self.reader(own) for own in schema['prefixItems'])})"
        return f"every({self.reader(schema['items'])})"


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
    return NAMES.get(name, re.sub(r"\W", "", name))


def camel(word: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in re.split(r"[-_]", word))


def field_name(raw: str) -> str:
    """The name of an attribute: what Python or the types have a meaning for gets a `_` behind it."""
    own = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", raw).replace("-", "_").lower()
    return own + "_" if keyword.iskeyword(own) or own in BUILTIN else own


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
    unknown = set(NAMES) - set(definitions)
    if unknown:
        sys.exit(f"there is no structure {unknown.pop()}: take it out of NAMES, or name what it has become")
    types = Types(definitions, results)
    out = ""
    names: list[str] = []
    for name in sorted(definitions, key=python_name):
        schema = definitions[name]
        variants = types.variants(schema)
        if variants is not None:
            out += one_of(types, python_name(name), schema, variants)
        elif (properties := types.merged(schema)) is not None:
            out += structure(types, name, properties)
        else:
            continue
        names.append(python_name(name))
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        sys.exit(f"two structures are called {twice.pop()}: give one of them another name in NAMES")
    return HEAD + "__all__ = [\n" + "".join(f'    "{name}",\n' for name in names) + "]\n" + out


def one_of(types: Types, name: str, schema: dict[str, Any], variants: list[tuple[str, dict[str, Any] | None, str]]) -> str:
    """A class for a union: which variant it is, and what is in each."""
    filled = [(word, content, doc) for word, content, doc in variants if content is not None]
    fields = [field_name(word) for word, _, _ in filled]
    clash = ({"kind", *TAKEN} & set(fields)) or {own for own in fields if fields.count(own) > 1}
    if clash:
        sys.exit(f"{name} has a variant {clash.pop()}, which is the name of something else: rename it")
    out = f"\n\nclass {name}(Variant):\n" + doc(schema.get("description", ""), "    ")
    out += "\n    __slots__ = ()\n"
    out += "    _FIELDS = (" + "".join(f'"{own}", ' for own in ["kind", *fields]).rstrip(" ") + ")\n"
    words = ", ".join(repr(word) for word, _, _ in variants)
    empty = "".join(f"\n`{word}`: {meaning}" for word, content, meaning in variants if content is None and meaning)
    out += f"\n    @property\n    def kind(self) -> Literal[{words}]:\n" + doc("Which of the variants it is." + empty, "        ")
    out += "        return self._kind()  # type: ignore[no-any-return]\n"
    for (word, content, meaning), own in zip(filled, fields, strict=True):
        out += field(types, name, word, own, {"description": meaning, **(content or {})}, required=False)
    return out


def structure(types: Types, name: str, properties: dict[str, Any]) -> str:
    """A class for a structure."""
    base = "Result" if name in types.results else "Matrices" if name in SQUARE else "Record"
    out = f"\n\nclass {python_name(name)}({base}):\n" + doc(types.definitions[name].get("description", ""), "    ")
    fields = {raw: field_name(raw) for raw in properties}
    clash = TAKEN.intersection(fields.values()) if base == "Result" else set()
    if clash:
        sys.exit(f"{name} has a field {clash.pop()}, which every result has as a method: rename one of them")
    out += "\n    __slots__ = ()\n"
    out += "    _FIELDS = (" + "".join(f'"{own}", ' for own in fields.values()).rstrip(" ") + ")\n"
    if name in SQUARE:
        out += f"    _SQUARE = {tuple(sorted(SQUARE[name]))!r}\n".replace("'", '"')
    for raw, own in fields.items():
        schema, required = properties[raw]
        out += field(types, name, raw, own, schema, required)
    return out


def field(types: Types, name: str, raw: str, own: str, schema: Any, required: bool) -> str:
    """A property for a field."""
    how, kind = types.kind(schema)
    if not required and how in ("get", "of"):
        kind = optional(kind)
    if how == "of":
        body = f'self._of("{raw}", {kind.removesuffix(" | None")})'
    elif how == "all":
        body = f'self._all("{raw}", {kind[8:].split("]")[0]})'
    elif how == "as":
        reader = types.reader(schema)
        if not required and not kind.startswith("list["):
            kind = optional(kind)
        body = f'self._as("{raw}", {reader}, {"[]" if kind.startswith("list[") and not kind.endswith("| None") else "None"})'
    elif raw in SQUARE.get(name, ()):
        body = f'self._square("{raw}")'
    else:
        # What may be left out is None, not an empty list.
        own_how = "get" if how == "list" and kind.endswith("| None") else how
        body = f'self._{own_how}("{raw}")'
    out = f"\n    @property\n    def {own}(self) -> {kind}:\n" + doc(field_doc(schema, types.definitions), "        ")
    return out + (f"        return {body}  # type: ignore[no-any-return]\n" if how != "all" else f"        return {body}\n")


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
