# SPDX-License-Identifier: GPL-2.0-or-later
# Doxygen's input filter, so that headers can stay plain. Lines keep their numbers.
#
# The first block of `///` lines of a header describes the file; Doxygen believes that where the block says \file, which
# goes onto the empty line before it. A paragraph that begins indented, and not as a list, is a picture or a table: each
# line of it is indented by four more, which is how Markdown is told to leave it as it stands.

/^ *\/\/\// {
  if (held == "" && !described) {
    held = "/// \\file"
    described = 1
  }
  text = $0
  sub(/^ *\/\/\//, "", text)
  blank = text ~ /^ *$/
  if (after_blank && text ~ /^   / && text !~ /^ *(-|[0-9]+\.) /) in_picture = 1
  if (blank) in_picture = 0
  if (in_picture) sub(/\/\/\//, "///    ")
  after_blank = blank
}
!/^ *\/\/\// { in_picture = after_blank = 0 }

# A line is printed when the next one has been seen.
NR > 1 { print held }
{ held = $0 }
END { print held }
