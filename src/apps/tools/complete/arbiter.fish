# Completes arbiter(1) in fish. The command itself lists the possible words, so that nothing here can
# be out of date.

function __arbiter_complete
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    for answer in ($words[1] complete -- $words[2..-1] "$typed" 2>/dev/null)
        switch $answer
            case ':files*'
                # Behind "--option=" or "0=" too.
                set -l before (string replace -r '^:files ?' '' -- $answer)
                set -l length (string length -- $before)
                for path in (__fish_complete_path (string sub -s (math $length + 1) -- $typed))
                    printf "%s\n" $before$path
                end
            case ':hint *'
                # fish shows no text that is no candidate.
            case ':command *'
                set -l first (string replace ':command ' '' -- $answer)
                set -l command $words[(math $first + 2)..-1] $typed
                complete -C (string join ' ' -- (string escape -- $command[1..-2]) $command[-1])
            case '*'
                echo $answer
        end
    end
end

complete -c arbiter -f -a '(__arbiter_complete)'
