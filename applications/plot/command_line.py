# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Contrecoup authors
"""Calls commands by their names. A command is a module of plot.commands: its
docstring is the help text, the parameters of its main() are the arguments."""

import importlib
import inspect
import pkgutil
import signal
import sys

from plot import commands
from plot.figures import style
from plot.readers.files import BrokenInput

HELP = ("--help", "-h")


def names():
    """All commands."""
    return sorted(module.name for module in
                  pkgutil.iter_modules(commands.__path__))


def load(name):
    return importlib.import_module(f"plot.commands.{name}")


def usage(main):
    """The arguments of a command: FOLDER, [FOLDER] or [FOLDERS...]."""
    return " ".join(
        ("[{}...]" if parameter.kind is parameter.VAR_POSITIONAL else
         "{}" if parameter.default is parameter.empty else "[{}]"
         ).format(name.upper())
        for name, parameter in inspect.signature(main).parameters.items())


def values_of(main, arguments):
    """The arguments, those that main() annotates with float as numbers. Raises
    TypeError if there are too few or too many, BrokenInput for no number."""
    bound = inspect.signature(main).bind(*arguments)
    for name, value in bound.arguments.items():
        if bound.signature.parameters[name].annotation is float:
            try:
                bound.arguments[name] = float(value)
            except ValueError as problem:
                raise BrokenInput(f"{name.upper()} must be a number, not "
                                  f"'{value}'") from problem
    return bound.args


def run(arguments, documentation=""):
    """Runs the command that is the first argument; returns the exit code.
    @p documentation is the help text on all commands."""
    # A reader that closes the pipe early, as head does, is no error.
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    if not arguments or arguments[0] in HELP:
        print(documentation.strip() + "\n\nCommands:\n  "
              + "\n  ".join(f"{name} {usage(load(name).main)}"
                            for name in names()),
              file=sys.stdout if arguments else sys.stderr)
        return 0 if arguments else 1
    name, *arguments = arguments
    program = f"plot.py {name}"
    if name not in names():
        print(f"plot.py: there is no command '{name}'; there are: "
              + ", ".join(names()), file=sys.stderr)
        return 1
    command = load(name)
    if any(word in HELP for word in arguments):
        print(command.__doc__.strip())
        return 0
    style.set_up()
    try:
        try:
            values = values_of(command.main, arguments)
        except TypeError:
            print(f"usage: {program} {usage(command.main)}", file=sys.stderr)
            return 1
        command.main(*values)
    except (BrokenInput, OSError) as problem:
        print(f"{program}: {problem}", file=sys.stderr)
        return 1
    return 0
