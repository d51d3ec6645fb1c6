#compdef tetrarch
# Completion of tetrarch for zsh. Generated from the table of commands, `tetrarch help --json`.

_tetrarch_census_names() {
  local -a names=(@CENSUS@)
  _describe 'census name' names
}

# Names only for those who have begun one: they are many.
_tetrarch_manifolds() {
  local -a alternatives=('files:triangulation or mesh:_files')
  [[ -z $PREFIX ]] || alternatives+=('names:census name:_tetrarch_census_names')
  _alternative $alternatives
}

# The first word of a command or, after such a first word, the second one.
_tetrarch_commands() {
  local -a verbs
  case $1 in
    '' | help)
      verbs=(
@FIRST@
      ) ;;
@SECOND@
  esac
  _describe command verbs
}

_tetrarch_command() {
  case $1 in
@TABLE@
  esac
}

_tetrarch() {
  local curcontext=$curcontext state name
  _arguments -C '(- *)'{-h,--help}'[the commands]' '(- *)--version[versions of the program and its libraries]' \
    '1:command: _tetrarch_commands' '*::argument:->arguments'
  [[ $state == arguments ]] || return
  name=$words[1]
  case $name in
    @GROUPS@)
      if ((CURRENT == 2)); then
        _tetrarch_commands $name
        return
      fi
      name+=" $words[2]"
      shift words
      ((CURRENT--)) ;;
  esac
  _tetrarch_command $name
}

_tetrarch "$@"
