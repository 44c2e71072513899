# SPDX-License-Identifier: BSD-3-Clause
# Makes a man page of what a program prints for --help:
#   PROGRAM --help | awk -v program=PROGRAM -v version=0.1.0 -v others="voxeland-info ..." -f from_help.awk
# Help is a description whose first clause names the program, with indented lines for examples, maybe
# lines that begin with "Usage: PROGRAM" or "Exit codes:", then "Options:", each an indented line, with
# its text indented deeper.

# What roff would take for its own.
function text(line) {
    gsub(/\\/, "\\e", line)
    gsub(/-/, "\\-", line)
    if (line ~ /^[.']/) line = "\\&" line
    return line
}

function section(title, body) {
    if (body != "") printf ".SH %s\n%s", title, body
}

# "0 done, 1 wrong usage" as a list.
function statuses(codes,    list, count, i, number) {
    gsub(/, [0-9]/, "\n&", codes)
    count = split(codes, list, /\n, /)
    for (i = 1; i <= count; i++) {
        number = list[i]
        sub(/ .*/, "", number)
        sub(/^[0-9]+ /, "", list[i])
        sub(/\.$/, "", list[i])
        printf ".TP\n%s\n%s\n", number, text(list[i])
    }
}

BEGIN {
    codes = "0 done, 1 wrong usage or configuration, 2 a plugin cannot be used, " \
        "3 unreadable or damaged input, 4 nothing to map, 5 output that cannot be written"
}
/^Options:$/ { inOptions = 1; next }
/^Examples:$/ { next }
inOptions && /^  [^ ]/ {
    sub(/^  /, "")
    gsub(/,  /, ", ")
    optionLine = $0
    options = options ".TP\n.B " text($0) "\n"
    next
}
inOptions {
    sub(/^ +/, "")
    if (sub(/^\(required\)  /, "")) {
        sub(/,.*/, "", optionLine)
        required = required " " optionLine
    }
    options = options text($0) "\n"
    next
}
sub(/^Usage: [^ ]+ /, "") { usage = $0; next }
sub(/^Exit codes: /, "") { codes = $0; inCodes = 1; next }
inCodes && /^[^ ]/ { codes = codes " " $0; next }
{ inCodes = 0 }
/^  / {
    examples = examples text(substr($0, 3)) "\n"
    next
}
/^$/ {
    if (description != "" && description !~ /\.PP\n$/) description = description ".PP\n"
    next
}
{
    if (name == "") {
        name = tolower(substr($0, 1, 1)) substr($0, 2)
        sub(/[.:,]( .*)?$/, "", name)
    }
    description = description text($0) "\n"
}
END {
    if (name == "" || options == "") {
        print program ": no man page can be made of its --help" > "/dev/stderr"
        exit 1
    }
    sub(/\.PP\n$/, "", description)
    printf ".TH %s 1 \"\" \"Voxeland %s\" \"Voxeland for MRPT\"\n", toupper(program), version
    section("NAME", text(program) " \\- " text(name) "\n")
    section("SYNOPSIS", ".B " text(program required) "\n" text(usage == "" ? "[option]..." : usage) "\n")
    section("DESCRIPTION", description)
    section("OPTIONS", options)
    section("EXAMPLES", examples == "" ? "" : ".nf\n" examples ".fi\n")
    print ".SH \"EXIT STATUS\""
    statuses(codes)
    print ".SH \"SEE ALSO\""
    count = split(others, list, " ")
    for (i = 1; i <= count; i++)
        if (list[i] != program) {
            printf "%s.BR %s (1)", separator, text(list[i])
            separator = ",\n"
        }
    print ""
}
