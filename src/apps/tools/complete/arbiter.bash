# Completes arbiter(1) in bash. The command itself lists the possible words, so that nothing here can
# be out of date.

_arbiter() {
  local line=${COMP_LINE:0:COMP_POINT} answer word before kept i
  local -a words
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=('')
  local typed=${words[-1]}
  # bash treats the text after a colon or an equals sign as a separate word.
  kept=${typed%"${typed##*[:=]}"}
  COMPREPLY=()
  while IFS= read -r answer; do
    case $answer in
      :files*)
        # File names can also follow "--option=" or "0=".
        before=${answer#:files} before=${before# }
        compopt -o filenames
        while IFS= read -r word; do word=$before$word COMPREPLY+=("${word#"$kept"}"); done \
          < <(compgen -f -- "${typed#"$before"}")
        ;;
      ':hint '*)
        # With two candidates, bash shows the hint and inserts none.
        [[ -z $typed ]] && COMPREPLY+=("${answer#:hint }" ' ')
        ;;
      ':command '*)
        i=${answer#:command }
        if declare -F _command_offset >/dev/null && [[ ${words[*]:0:i+1} != *[:=]* ]]; then
          _command_offset $((i + 1))
        else
          compopt -o filenames
          while IFS= read -r word; do COMPREPLY+=("$word"); done \
            < <(if ((i + 2 == ${#words[@]})); then compgen -c -- "$typed"; else compgen -f -- "$typed"; fi)
        fi
        ;;
      *)
        word=${answer%%$'\t'*}
        COMPREPLY+=("${word#"$kept"}")
        ;;
    esac
  done < <("${words[0]}" complete -- "${words[@]:1}" 2>/dev/null)
}
complete -F _arbiter arbiter
