# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Values of a summary.json without their units, and its schema."""

import json
import os

import jsonschema

SCHEMAS = os.path.abspath(os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "../../..", "applications",
    "schemas"))


def values_of(summary, group):
    """Values of "results" or "checks" by name; {} without such a group."""
    return {name: entry["value"]
            for name, entry in summary.get(group, {}).items()}


def flaw_of(path):
    """Violation of its schema in applications/schemas by a summary.json or
    scene.json, in words; "" for none."""
    name = os.path.splitext(os.path.basename(path))[0] + ".schema.json"
    with open(os.path.join(SCHEMAS, name), encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    for error in jsonschema.Draft202012Validator(schema).iter_errors(content):
        return f"{error.json_path}: {error.message}"
    return ""
