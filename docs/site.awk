# SPDX-License-Identifier: BSD-3-Clause
# Doxygen's filter for pages: what a git host does with Markdown by itself is said in Doxygen's words.
#   awk -v top=SOURCES -f site.awk SOURCES/docs/get-started.md
# - Headings get the anchors of a git host, with the page's name in front. Those of the first page are no
#   branches of the tree.
# - Links to other pages become references; a list item that begins with one, a branch of the tree.
# - Links to files that are no pages become their text; pictures are found by their name.
# - Blocks of code keep the first word behind ``` only.

BEGIN { ticks = sprintf("%c", 96); fence = ticks ticks ticks }

FNR == 1 {
    file = substr(FILENAME, length(top) + 2)
    folder = file
    if (!sub(/\/[^\/]*$/, "", folder)) folder = ""
    page = pageOf(file)
}

index($0, fence) > 0 && $0 ~ "^ *" fence {
    inCode = !inCode
    if (inCode) sub(/ needs=.*$/, "")
    print
    next
}
inCode { print; next }

/^#+ / {
    title = $0
    sub(/^#+ /, "", title)
    if (/^# /) print $0 " {#" page "}"
    else if (page == "mainpage") print "@anchor " page "_" anchorOf(title) "\n\n" $0
    else print $0 " {#" page "_" anchorOf(title) "}"
    next
}

{ print linked($0) }

# Name of a page in the site: docs/developer/add-plugin.md is developer-add-plugin.
function pageOf(path) {
    if (path == "README.md") return "mainpage"
    sub(/\.md$/, "", path)
    sub(/^docs\//, "", path)
    sub(/\/README$/, "", path)
    gsub(/\//, "-", path)
    return tolower(path)
}

# The anchor that a git host gives a heading: of equal ones the later ones get a number.
function anchorOf(heading,    times) {
    heading = tolower(heading)
    gsub(/[^a-z0-9 _-]/, "", heading)
    gsub(/ /, "-", heading)
    times = seen[heading]++
    return heading (times > 0 ? "-" times : "")
}

# A path from the top, of one from this file's folder.
function fromTop(path,    part, count, i, kept, result) {
    count = split((folder == "" ? "" : folder "/") path, part, "/")
    kept = 0
    for (i = 1; i <= count; ++i) {
        if (part[i] == "..") --kept
        else if (part[i] != ".") part[++kept] = part[i]
    }
    for (i = 1; i <= kept; ++i) result = result (i > 1 ? "/" : "") part[i]
    return result
}

# A line whose links are those of the site.
function linked(line,    done, text, target, start) {
    done = ""
    while (match(line, /\[[^][]*\]\([^() ]*\)/)) {
        start = substr(line, 1, RSTART - 1)
        text = substr(line, RSTART, RLENGTH)
        line = substr(line, RSTART + RLENGTH)
        target = text
        sub(/^\[[^][]*\]\(/, "", target)
        sub(/\)$/, "", target)
        sub(/\]\(.*$/, "", text)
        sub(/^\[/, "", text)
        done = done start link(text, target, done start)
    }
    return done line
}

function link(text, target, before,    anchor, path) {
    if (target ~ /^[a-z]+:/) return "[" text "](" target ")"
    if (before ~ /!$/) {
        sub(/^.*\//, "", target)
        return "[" text "](" target ")"
    }
    anchor = ""
    if (target ~ /#/) {
        anchor = target
        sub(/^[^#]*#/, "", anchor)
        sub(/#.*$/, "", target)
    }
    path = target == "" ? file : fromTop(target)
    if (path !~ /\.md$/) return text
    gsub(ticks, "", text)
    path = pageOf(path)
    if (anchor != "") return "[" text "](@ref " path "_" anchor ")"
    if (path == "mainpage") return "[" text "](index.html)"
    if (before == "- ") return "@subpage " path " \"" text "\""
    return "[" text "](@ref " path ")"
}
