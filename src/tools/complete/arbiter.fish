# Completes arbiter(1) in fish. The command itself lists the possible words, so that nothing here can
# be out of date.

function __arbiter_complete
    set -l words (commandline -opc)
    set -l typed (commandline -ct)
    for answer in ($words[1] complete -- $words[2..-1] "$typed" 2>/dev/null)
        switch $answer
            case :files
                if string match -qr '^--[^=]+=' -- $typed
                    set -l parts (string split -m 1 = -- $typed)
                    printf "$parts[1]=%s\n" (__fish_complete_path $parts[2])
                else
                    __fish_complete_path $typed
                end
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
