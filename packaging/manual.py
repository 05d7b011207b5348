#!/usr/bin/env python3
"""The manual page and the completions of the tool, from what its --help says.

    packaging/manual.py TOOL           writes signum.1, completions/signum.bash and completions/_signum beside this script
    packaging/manual.py TOOL --check   ends with 1 where these are not what would be written

The page repeats the help line by line. What completes are subcommands, options and those words that the help lists.
"""
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
COLUMN = 30  # where the help says what an option is


class Entry:
    """An option, a positional or a subcommand: its head, and the lines about it."""

    def __init__(self, head):
        self.head = head
        self.lines = []
        call = re.split(" Excludes:| REQUIRED", head)[0]
        self.name = next(iter(re.findall(r"--[a-z][a-z0-9-]*", call)), call.split(" ")[0])
        self.takes = re.sub(r"^\S+ ?|=.*", "", call)  # its argument; nothing where it is a flag

    def words(self):
        """What may stand behind it: radius|weight, or the names of a table in two columns."""
        choice = re.fullmatch(r"\w+(\|\w+)+", self.takes)
        return choice[0].split("|") if choice else \
            list(dict.fromkeys(row[1] for line in self.lines if (row := re.match(r"(\w+)  +\S", line))))


class Help:
    """--help in parts: what it is, how it is called, entries under their titles, and what is said at the end."""

    def __init__(self, *call):
        lines = subprocess.run([*call, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout.rstrip().split("\n")
        self.description, self.usage = lines[0], lines[1].removeprefix("Usage: ")
        self.sections, self.end = {}, []
        entries = None
        for line in lines[2:]:
            if title := re.fullmatch(r"(Positionals|Options|Subcommands):", line):
                entries = self.sections.setdefault(title[1], [])
            elif entries is not None and line.startswith(" " * COLUMN):
                entries[-1].lines.append(line[COLUMN:])
            elif entries is not None and line.startswith("  "):
                with_text = line[COLUMN - 2:COLUMN] == "  "
                entries.append(Entry(line[:COLUMN].strip() if with_text else line.strip()))
                entries[-1].lines += [line[COLUMN:]] if with_text else []
            elif line or self.end:
                entries = None
                self.end.append(line)

    def options(self):
        return self.sections["Options"]


def roff(line):
    line = line.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + line if line[:1] in (".", "'") else line


def as_it_stands(lines):
    return [".nf", *map(roff, lines), ".fi"]


def page(version, tool, commands):
    text = [f'.TH SIGNUM 1 "" "signum {version}" "User Commands"', ".SH NAME",
            "signum \\- " + roff(tool.description[0].lower() + tool.description[1:]), ".SH SYNOPSIS",
            *(f".B signum {name}\n{roff(help.usage.removeprefix('signum ' + name + ' '))}\n.br"
              for name, help in commands.items()),
            ".B signum\n\\-\\-version | \\-\\-help", ".SH DESCRIPTION",
            "Every sign that signum computes is exact, for all finite doubles; the same input gives the same bytes.",
            "What it writes goes beside a file first, and is renamed when it is complete."]
    for name, help in commands.items():
        text += [f".SH {name.upper()}", roff(help.description) + "."]
        for entry in help.sections.get("Positionals", []) + help.options():
            text += [".TP", f".B {roff(entry.head)}", *as_it_stands(entry.lines)]
        if help.end:
            text += [".PP", *as_it_stands(help.end)]
    text += [".SH EXIT STATUS", "0: done. 1: a check failed. 2: the call or its input is wrong; standard error says where.",
             "3: the machine failed, such as a full disk.", ".SH EXAMPLES", *as_it_stands(tool.end[tool.end.index("Example:") + 1:])]
    return "\n".join(text) + "\n"


def bash(commands):
    cases, values = [], []
    for name, help in commands.items():
        cases.append(f"        {name}) options='{' '.join(option.name for option in help.options())}' ;;")
        for entry in help.sections.get("Positionals", []) + help.options():
            if entry.words() and entry.takes:
                values.append(f"        {name}:{entry.name}) words='{' '.join(entry.words())}' ;;")
            elif entry.words():
                values.append(f"        {name}:) words='{' '.join(entry.words())}' ;;")
    return "\n".join([
        "# Completion of signum for bash; written by packaging/manual.py from the tool's help.",
        "_signum() {",
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} options='' words=''",
        "    COMPREPLY=()",
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then",
        f"        mapfile -t COMPREPLY < <(compgen -W '{' '.join(commands)} --help --version' -- \"$word\")",
        "        return",
        "    fi",
        "    case $command in", *cases, "    esac",
        "    [ \"$COMP_CWORD\" -eq 2 ] && [[ $word != -* ]] && before=",
        "    case $command:$before in", *values, "    esac",
        "    if [ -n \"$words\" ]; then",
        "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")",
        "    elif [[ $word == -* ]]; then",
        "        mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")",
        "    fi",
        "}",
        "complete -o default -F _signum signum", ""])


def zsh(commands):
    def quoted(text):
        return re.sub(r"([\\\[\]:])", r"\\\1", text).replace("'", "'\\''")

    def specification(entry, positional):
        about = quoted(" ".join(entry.lines[:1])[:60].rstrip())
        words = entry.words()
        action = f"({' '.join(words)})" if words else "_files"
        if positional:
            return f"'*:{about}:{action}'"
        return f"'*{entry.name}[{about}]" + (f":{quoted(entry.takes)}:{action}'" if entry.takes else "'")

    text = ["#compdef signum", "# Completion of signum for zsh; written by packaging/manual.py from the tool's help.",
            "local -a commands", "commands=("]
    text += [f"    '{name}:{quoted(help.description)}'" for name, help in commands.items()]
    text += [")", "if (( CURRENT == 2 )); then", "    _describe -t commands 'signum command' commands",
             "    _arguments '--help[says more]' '--version[says which one it is]'", "    return", "fi",
             "local command=$words[2]", "shift words", "(( CURRENT-- ))", "case $command in"]
    for name, help in commands.items():
        entries = [specification(entry, False) for entry in help.options()]
        entries += [specification(entry, True) for entry in help.sections.get("Positionals", [])[:1]]
        text += [f"    {name})", "        _arguments \\"]
        text += [f"            {entry} \\" for entry in entries[:-1]] + [f"            {entries[-1]}", "        ;;"]
    return "\n".join(text + ["esac", ""])


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    program = sys.argv[1]
    version = subprocess.run([program, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()[-1]
    tool = Help(program)
    commands = {entry.name: Help(program, entry.name) for entry in tool.sections["Subcommands"]}
    files = {"signum.1": page(version, tool, commands), "completions/signum.bash": bash(commands),
             "completions/_signum": zsh(commands)}
    for name, text in files.items():
        if sys.argv[2:] == []:
            (HERE / name).write_text(text)
        elif (HERE / name).read_text() != text:
            sys.exit(f"packaging/{name} is not what the tool's --help says: packaging/manual.py writes it")
    # The help was understood: each option of two dashes that stands in its left column is among those that complete.
    for name, help in commands.items():
        shown = subprocess.run([program, name, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
        listed = set(re.findall(r"^  (?:-\w,)?(--[a-z0-9-]+)", shown, re.MULTILINE))
        missing = listed - {option.name for option in help.options()}
        if missing or not listed:
            sys.exit(f"manual.py does not understand what signum {name} --help says of {missing or 'options'}")


if __name__ == "__main__":
    main()
