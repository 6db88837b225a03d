" Programs are known by their header; files that are still empty by their names.
autocmd BufNewFile,BufRead *
      \ if getline(1) =~# '^!!\%(\%(ARB[fv]p\|ATIfs\|FP\|VP\|VSP\|RC\|TS\)1\.0\|VP1\.1\|VP2\.0\)' | set filetype=arbprogram | endif
autocmd BufNewFile,BufRead *.arbfp,*.arbvp,*.atifs,*.nvrc,*.nvts set filetype=arbprogram
autocmd BufNewFile *.fp,*.vp set filetype=arbprogram
