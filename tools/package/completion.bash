# Completion of tetrarch for bash. Generated from the table of commands, `tetrarch help --json`.

_tetrarch_commands='@COMMANDS@'
_tetrarch_census='@CENSUS@'

# Of the command $1: its options, the kinds of value that some of them take, and the kinds of its arguments
# (+: repeated). A kind is file, manifold, census, command, word (nothing to offer) or a list of choices.
_tetrarch_describe() {
  case $1 in
@TABLE@
    *) return 1 ;;
  esac
}

# The words that may follow the words $* of a command's name.
_tetrarch_next_words() {
  local name before="$*" last=
  while read -r name; do
    [[ -z $before || $name == "$before "* ]] || continue
    name=${name#"$before"}
    name=${name# }
    [[ ${name%% *} == "$last" ]] || echo "${name%% *}"
    last=${name%% *}
  done <<<"$_tetrarch_commands"
}

_tetrarch_value_kind() { # OPTION
  local entry
  for entry in $values; do
    [[ $entry == "$1="* ]] && echo "${entry#*=}" && return
  done
  return 1
}

# The kind of the argument that comes next, after the words $*.
_tetrarch_argument_kind() {
  local word kind='' skip='' rest
  read -ra rest <<<"$arguments"
  for word; do
    if [[ $skip ]]; then
      skip=
    elif [[ $word == -?* ]]; then
      _tetrarch_value_kind "$word" >/dev/null && skip=yes
    elif [[ ${rest[0]-} != *+ ]]; then
      rest=("${rest[@]:1}")
    fi
  done
  kind=${rest[0]-}
  echo "${kind%+}"
}

_tetrarch_offer() { # KIND CURRENT; the words of a command's name follow
  local kind=$1 current=$2
  case $kind in
    '' | word) return ;;
    command) COMPREPLY=($(compgen -W "$(_tetrarch_next_words "${@:3}")" -- "$current")) ;;
    census) COMPREPLY=($(compgen -W "$_tetrarch_census" -- "$current")) ;;
    file | manifold)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      # So many names are offered only to those who have begun one.
      [[ $kind == file || -z $current ]] || COMPREPLY+=($(compgen -W "$_tetrarch_census" -- "$current")) ;;
    *) COMPREPLY=($(compgen -W "${kind//,/ }" -- "$current")) ;;
  esac
}

_tetrarch() {
  local current=${COMP_WORDS[COMP_CWORD]} word length=1 kind options values arguments
  local -a before=()
  COMPREPLY=()
  # Bash splits --method=flow at the sign; "--method flow" means the same.
  [[ $current != '=' ]] || current=
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == '=' ]] || before+=("$word")
  done
  _tetrarch_describe "${before[*]:0:2}" && length=2 || _tetrarch_describe "${before[0]-}" || {
    options=$(_tetrarch_next_words "${before[@]}")
    [[ ${#before[@]} -gt 0 ]] || options+=' --help --version'
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  }
  before=("${before[@]:length}")
  if [[ ${#before[@]} -gt 0 ]] && kind=$(_tetrarch_value_kind "${before[-1]}"); then
    _tetrarch_offer "$kind" "$current"
  elif [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  else
    _tetrarch_offer "$(_tetrarch_argument_kind "${before[@]}")" "$current" "${before[@]}"
  fi
}

complete -F _tetrarch tetrarch
