" ARB assembly programs and ATI fragment shaders: comments, and :make.
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal comments=:#
setlocal commentstring=#\ %s
setlocal iskeyword=@,48-57,_,$

" :make fills the quickfix list; :make --profile=nv30 asks for another card.
setlocal makeprg=arbiter\ check\ --brief\ $*\ %:S
setlocal errorformat=%f:%l:%c:\ %trror:\ %m,%f:%l:%c:\ %tarning:\ %m,%f:%l:%c:\ %tote:\ %m

let b:undo_ftplugin = 'setlocal comments< commentstring< iskeyword< makeprg< errorformat<'
