" Programs are known by their header; files that are still empty by their names.
autocmd BufNewFile,BufRead *
      \ if getline(1) =~# '^!!\%(\%(ARB[fv]p\|ATIfs\|FP\|VP\|VSP\|RC\|TS\)1\.0\|VP1\.1\|VP2\.0\)' | set filetype=arbprogram | endif
" A program behind comments: these files hold a vertex and a fragment program.
autocmd BufNewFile,BufRead *.vfp set filetype=arbprogram
autocmd BufNewFile,BufRead *.arbfp,*.arbvp,*.atifs,*.nvrc,*.nvts,*.vsp set filetype=arbprogram
autocmd BufNewFile *.fp,*.vp set filetype=arbprogram
