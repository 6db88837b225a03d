;;; arbprogram-mode.el --- Major mode for ARB assembly programs  -*- lexical-binding: t -*-
;; editors/generate.py writes the lists of words from the compiler's tables.

;;; Commentary:
;; Syntax of !!ARBfp1.0, !!ARBvp1.0, !!ATIfs1.0 and NVIDIA's languages, M-x compile by `arbiter check',
;; and the language server `arbiter lsp' for eglot and lsp-mode.

;;; Code:

(defvar arbprogram-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?# "<" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?$ "w" table)
    table))

(defconst arbprogram-opcodes
  '("ABS" "ABS_SAT" "ADD" "ADD_SAT" "CMP" "CMP_SAT" "COS" "COS_SAT" "DP3" "DP3_SAT" "DP4" "DP4_SAT"
    "DPH" "DPH_SAT" "DST" "DST_SAT" "EX2" "EX2_SAT" "FLR" "FLR_SAT" "FRC" "FRC_SAT" "LG2"
    "LG2_SAT" "LIT" "LIT_SAT" "LRP" "LRP_SAT" "MAD" "MAD_SAT" "MAX" "MAX_SAT" "MIN" "MIN_SAT"
    "MOV" "MOV_SAT" "MUL" "MUL_SAT" "POW" "POW_SAT" "RCP" "RCP_SAT" "RSQ" "RSQ_SAT" "SCS"
    "SCS_SAT" "SGE" "SGE_SAT" "SIN" "SIN_SAT" "SLT" "SLT_SAT" "SUB" "SUB_SAT" "SWZ" "SWZ_SAT"
    "XPD" "XPD_SAT" "TEX" "TEX_SAT" "TXP" "TXP_SAT" "TXB" "TXB_SAT" "KIL" "ARL" "EXP" "LOG"
    "ADDC" "ADDC_SAT" "ADDR" "ADDR_SAT" "ADDRC" "ADDRC_SAT" "ADDH" "ADDH_SAT" "ADDHC"
    "ADDHC_SAT" "ADDX" "ADDX_SAT" "ADDXC" "ADDXC_SAT" "COSC" "COSC_SAT" "COSR" "COSR_SAT"
    "COSRC" "COSRC_SAT" "COSH" "COSH_SAT" "COSHC" "COSHC_SAT" "DP3C" "DP3C_SAT" "DP3R"
    "DP3R_SAT" "DP3RC" "DP3RC_SAT" "DP3H" "DP3H_SAT" "DP3HC" "DP3HC_SAT" "DP3X" "DP3X_SAT"
    "DP3XC" "DP3XC_SAT" "DP4C" "DP4C_SAT" "DP4R" "DP4R_SAT" "DP4RC" "DP4RC_SAT" "DP4H"
    "DP4H_SAT" "DP4HC" "DP4HC_SAT" "DP4X" "DP4X_SAT" "DP4XC" "DP4XC_SAT" "DSTC" "DSTC_SAT"
    "DSTR" "DSTR_SAT" "DSTRC" "DSTRC_SAT" "DSTH" "DSTH_SAT" "DSTHC" "DSTHC_SAT" "EX2C"
    "EX2C_SAT" "EX2R" "EX2R_SAT" "EX2RC" "EX2RC_SAT" "EX2H" "EX2H_SAT" "EX2HC" "EX2HC_SAT"
    "FLRC" "FLRC_SAT" "FLRR" "FLRR_SAT" "FLRRC" "FLRRC_SAT" "FLRH" "FLRH_SAT" "FLRHC"
    "FLRHC_SAT" "FLRX" "FLRX_SAT" "FLRXC" "FLRXC_SAT" "FRCC" "FRCC_SAT" "FRCR" "FRCR_SAT"
    "FRCRC" "FRCRC_SAT" "FRCH" "FRCH_SAT" "FRCHC" "FRCHC_SAT" "FRCX" "FRCX_SAT" "FRCXC"
    "FRCXC_SAT" "LG2C" "LG2C_SAT" "LG2R" "LG2R_SAT" "LG2RC" "LG2RC_SAT" "LG2H" "LG2H_SAT"
    "LG2HC" "LG2HC_SAT" "LITC" "LITC_SAT" "LITR" "LITR_SAT" "LITRC" "LITRC_SAT" "LITH"
    "LITH_SAT" "LITHC" "LITHC_SAT" "LRPC" "LRPC_SAT" "LRPR" "LRPR_SAT" "LRPRC" "LRPRC_SAT"
    "LRPH" "LRPH_SAT" "LRPHC" "LRPHC_SAT" "LRPX" "LRPX_SAT" "LRPXC" "LRPXC_SAT" "MADC"
    "MADC_SAT" "MADR" "MADR_SAT" "MADRC" "MADRC_SAT" "MADH" "MADH_SAT" "MADHC" "MADHC_SAT"
    "MADX" "MADX_SAT" "MADXC" "MADXC_SAT" "MAXC" "MAXC_SAT" "MAXR" "MAXR_SAT" "MAXRC"
    "MAXRC_SAT" "MAXH" "MAXH_SAT" "MAXHC" "MAXHC_SAT" "MAXX" "MAXX_SAT" "MAXXC" "MAXXC_SAT"
    "MINC" "MINC_SAT" "MINR" "MINR_SAT" "MINRC" "MINRC_SAT" "MINH" "MINH_SAT" "MINHC"
    "MINHC_SAT" "MINX" "MINX_SAT" "MINXC" "MINXC_SAT" "MOVC" "MOVC_SAT" "MOVR" "MOVR_SAT"
    "MOVRC" "MOVRC_SAT" "MOVH" "MOVH_SAT" "MOVHC" "MOVHC_SAT" "MOVX" "MOVX_SAT" "MOVXC"
    "MOVXC_SAT" "MULC" "MULC_SAT" "MULR" "MULR_SAT" "MULRC" "MULRC_SAT" "MULH" "MULH_SAT"
    "MULHC" "MULHC_SAT" "MULX" "MULX_SAT" "MULXC" "MULXC_SAT" "POWC" "POWC_SAT" "POWR"
    "POWR_SAT" "POWRC" "POWRC_SAT" "POWH" "POWH_SAT" "POWHC" "POWHC_SAT" "RCPC" "RCPC_SAT"
    "RCPR" "RCPR_SAT" "RCPRC" "RCPRC_SAT" "RCPH" "RCPH_SAT" "RCPHC" "RCPHC_SAT" "RSQC"
    "RSQC_SAT" "RSQR" "RSQR_SAT" "RSQRC" "RSQRC_SAT" "RSQH" "RSQH_SAT" "RSQHC" "RSQHC_SAT"
    "SGEC" "SGEC_SAT" "SGER" "SGER_SAT" "SGERC" "SGERC_SAT" "SGEH" "SGEH_SAT" "SGEHC"
    "SGEHC_SAT" "SGEX" "SGEX_SAT" "SGEXC" "SGEXC_SAT" "SINC" "SINC_SAT" "SINR" "SINR_SAT"
    "SINRC" "SINRC_SAT" "SINH" "SINH_SAT" "SINHC" "SINHC_SAT" "SLTC" "SLTC_SAT" "SLTR"
    "SLTR_SAT" "SLTRC" "SLTRC_SAT" "SLTH" "SLTH_SAT" "SLTHC" "SLTHC_SAT" "SLTX" "SLTX_SAT"
    "SLTXC" "SLTXC_SAT" "SUBC" "SUBC_SAT" "SUBR" "SUBR_SAT" "SUBRC" "SUBRC_SAT" "SUBH"
    "SUBH_SAT" "SUBHC" "SUBHC_SAT" "SUBX" "SUBX_SAT" "SUBXC" "SUBXC_SAT" "TEXC" "TEXC_SAT"
    "TXPC" "TXPC_SAT" "SEQ" "SEQ_SAT" "SEQC" "SEQC_SAT" "SEQR" "SEQR_SAT" "SEQRC" "SEQRC_SAT"
    "SEQH" "SEQH_SAT" "SEQHC" "SEQHC_SAT" "SEQX" "SEQX_SAT" "SEQXC" "SEQXC_SAT" "SNE" "SNE_SAT"
    "SNEC" "SNEC_SAT" "SNER" "SNER_SAT" "SNERC" "SNERC_SAT" "SNEH" "SNEH_SAT" "SNEHC"
    "SNEHC_SAT" "SNEX" "SNEX_SAT" "SNEXC" "SNEXC_SAT" "DDX" "DDX_SAT" "DDXC" "DDXC_SAT" "DDXR"
    "DDXR_SAT" "DDXRC" "DDXRC_SAT" "DDXH" "DDXH_SAT" "DDXHC" "DDXHC_SAT" "DDY" "DDY_SAT" "DDYC"
    "DDYC_SAT" "DDYR" "DDYR_SAT" "DDYRC" "DDYRC_SAT" "DDYH" "DDYH_SAT" "DDYHC" "DDYHC_SAT"
    "PK2H" "PK2US" "PK4B" "PK4UB" "UP2H" "UP2H_SAT" "UP2HC" "UP2HC_SAT" "UP2US" "UP2US_SAT"
    "UP2USC" "UP2USC_SAT" "UP4B" "UP4B_SAT" "UP4BC" "UP4BC_SAT" "UP4UB" "UP4UB_SAT" "UP4UBC"
    "UP4UBC_SAT" "TXD" "TXD_SAT" "TXDC" "TXDC_SAT" "SGT" "SGT_SAT" "SGTC" "SGTC_SAT" "SGTR"
    "SGTR_SAT" "SGTRC" "SGTRC_SAT" "SGTH" "SGTH_SAT" "SGTHC" "SGTHC_SAT" "SGTX" "SGTX_SAT"
    "SGTXC" "SGTXC_SAT" "SLE" "SLE_SAT" "SLEC" "SLEC_SAT" "SLER" "SLER_SAT" "SLERC" "SLERC_SAT"
    "SLEH" "SLEH_SAT" "SLEHC" "SLEHC_SAT" "SLEX" "SLEX_SAT" "SLEXC" "SLEXC_SAT" "STR" "STR_SAT"
    "STRC" "STRC_SAT" "STRR" "STRR_SAT" "STRRC" "STRRC_SAT" "STRH" "STRH_SAT" "STRHC"
    "STRHC_SAT" "STRX" "STRX_SAT" "STRXC" "STRXC_SAT" "SFL" "SFL_SAT" "SFLC" "SFLC_SAT" "SFLR"
    "SFLR_SAT" "SFLRC" "SFLRC_SAT" "SFLH" "SFLH_SAT" "SFLHC" "SFLHC_SAT" "SFLX" "SFLX_SAT"
    "SFLXC" "SFLXC_SAT" "X2D" "X2D_SAT" "X2DC" "X2DC_SAT" "X2DR" "X2DR_SAT" "X2DRC" "X2DRC_SAT"
    "X2DH" "X2DH_SAT" "X2DHC" "X2DHC_SAT" "RFL" "RFL_SAT" "RFLC" "RFLC_SAT" "RFLR" "RFLR_SAT"
    "RFLRC" "RFLRC_SAT" "RFLH" "RFLH_SAT" "RFLHC" "RFLHC_SAT" "ABSC" "DPHC" "ARLC" "EXPC" "LOGC"
    "ARR" "ARRC" "ARA" "ARAC" "SSG" "SSGC" "RCC" "RCCC" "BRA" "CAL" "RET" "DOT3" "DOT4" "LERP"
    "CND" "CND0" "DOT2ADD" "unsigned" "unsigned_invert" "expand" "half_bias" "sum" "mux" "lerp"
    "scale_by_two" "scale_by_four" "scale_by_one_half" "bias_by_negative_one_half"
    "bias_by_negative_one_half_scale_by_two" "clamp_color_sum" "per_stage_constants" "nop"
    "texture_1d" "texture_2d" "texture_rectangle" "texture_cube_map" "texture_3d" "pass_through"
    "cull_fragment" "offset_2d" "offset_2d_scale" "offset_rectangle" "offset_rectangle_scale"
    "dependent_ar" "dependent_gb" "dot_product_2d_1of2" "dot_product_2d_2of2"
    "dot_product_rectangle_1of2" "dot_product_rectangle_2of2" "dot_product_depth_replace_1of2"
    "dot_product_depth_replace_2of2" "dot_product_3d_1of3" "dot_product_3d_2of3"
    "dot_product_3d_3of3" "dot_product_cube_map_1of3" "dot_product_cube_map_2of3"
    "dot_product_cube_map_3of3" "dot_product_reflect_cube_map_eye_from_qs_1of3"
    "dot_product_reflect_cube_map_eye_from_qs_2of3"
    "dot_product_reflect_cube_map_eye_from_qs_3of3"
    "dot_product_reflect_cube_map_const_eye_1of3" "dot_product_reflect_cube_map_const_eye_2of3"
    "dot_product_reflect_cube_map_const_eye_3of3"
    "dot_product_cube_map_and_reflect_cube_map_eye_from_qs_1of3"
    "dot_product_cube_map_and_reflect_cube_map_eye_from_qs_2of3"
    "dot_product_cube_map_and_reflect_cube_map_eye_from_qs_3of3"
    "dot_product_cube_map_and_reflect_cube_map_const_eye_1of3"
    "dot_product_cube_map_and_reflect_cube_map_const_eye_2of3"
    "dot_product_cube_map_and_reflect_cube_map_const_eye_3of3" "offset_projective_2d"
    "offset_projective_2d_scale" "offset_projective_rectangle"
    "offset_projective_rectangle_scale" "offset_hilo_2d" "offset_hilo_rectangle"
    "offset_hilo_projective_2d" "offset_hilo_projective_rectangle" "dependent_hilo_2d"
    "dependent_rgb_3d" "dependent_rgb_cube_map" "dot_product_pass_through" "dot_product_1d"
    "dot_product_affine_depth_replace" "dot_product" "dot_product_2d" "dot_product_rectangle"
    "dot_product_depth_replace" "dot_product_3d" "dot_product_cube_map"
    "dot_product_diffuse_cube_map" "dot_product_reflect_cube_map_eye_from_qs"
    "dot_product_reflect_cube_map_const_eye"))

(defconst arbprogram-statements
  '("ALIAS" "ATTRIB" "OPTION" "OUTPUT" "PARAM" "TEMP" "END" "ADDRESS" "DEFINE" "DECLARE"
    "StartConstants" "EndConstants" "CONSTANT" "StartPrelimPass" "StartOutputPass" "EndPass"
    "PassTexCoord" "SampleMap" "rgb" "alpha" "out"))

(defconst arbprogram-bindings
  '("fragment" "program" "result" "state" "texture" "vertex" "WPOS" "COL0" "COL1" "FOGC" "COLR"
    "COLH" "DEPR" "TEX0" "TEX1" "TEX2" "TEX3" "TEX4" "TEX5" "TEX6" "TEX7" "TEX8" "TEX9" "TEX10"
    "TEX11" "TEX12" "TEX13" "TEX14" "TEX15" "OPOS" "WGHT" "NRML" "HPOS" "BFC0" "BFC1" "PSIZ"
    "color" "primary" "secondary" "texcoord" "fogcoord" "position" "depth" "env" "local"
    "material" "front" "back" "ambient" "diffuse" "specular" "emission" "shininess" "light"
    "attenuation" "spot" "direction" "half" "lightmodel" "scenecolor" "lightprod" "fog" "params"
    "texenv" "range" "matrix" "projection" "mvp" "inverse" "transpose" "invtrans" "row"
    "modelview" "palette" "normal" "attrib" "pointsize" "texgen" "eye" "object" "s" "t" "r" "q"
    "clip" "plane" "point" "size" "r0" "r1" "r2" "r3" "r4" "r5" "c0" "c1" "c2" "c3" "c4" "c5"
    "c6" "c7" "t0" "t1" "t2" "t3" "t4" "t5" "color0" "color1" "one" "zero" "const0" "const1"
    "col0" "col1" "spare0" "spare1" "tex0" "tex1" "tex2" "tex3" "tex4" "tex5" "tex6" "tex7"
    "final_product" "color_sum" "discard"))

(defconst arbprogram-options
  '("ARB_fog_exp" "ARB_fog_exp2" "ARB_fog_linear" "ARB_precision_hint_fastest"
    "ARB_precision_hint_nicest" "ARB_fragment_program_shadow" "ARB_draw_buffers"
    "ATI_draw_buffers" "ARB_fragment_coord_origin_upper_left"
    "ARB_fragment_coord_pixel_center_integer" "NV_fragment_program" "NV_fragment_program2" "1D"
    "2D" "3D" "CUBE" "RECT" "SHADOW1D" "SHADOW2D" "SHADOWRECT" "ARB_position_invariant"
    "NV_vertex_program2" "NV_vertex_program3" "NV_position_invariant" "GEQUAL_TO_ZERO"
    "LESS_THAN_ZERO" "force_blue_to_one"))

(defconst arbprogram-font-lock-keywords
  `(("\\`!![A-Za-z]+[0-9.]+" . font-lock-preprocessor-face)
    ("\\.[ \t]*\\([xyzwrgba]\\{1,4\\}\\)\\>" 1 font-lock-constant-face)
    (,(regexp-opt arbprogram-opcodes 'words) . font-lock-function-name-face)
    (,(regexp-opt arbprogram-statements 'words) . font-lock-keyword-face)
    (,(regexp-opt arbprogram-options 'words) . font-lock-type-face)
    (,(regexp-opt arbprogram-bindings 'words) . font-lock-variable-name-face)))

;;;###autoload
(define-derived-mode arbprogram-mode prog-mode "ARB program"
  "Major mode for ARB assembly programs and ATI fragment shaders."
  (setq-local comment-start "# ")
  (setq-local comment-start-skip "#+[ \t]*")
  (setq-local font-lock-defaults '(arbprogram-font-lock-keywords))
  (when buffer-file-name
    (setq-local compile-command
                (concat "arbiter check --brief " (shell-quote-argument buffer-file-name)))))

;;;###autoload
(progn
  (add-to-list 'auto-mode-alist
               '("\\.\\(?:v?fp\\|vp\\|arb[fv]p\\|atifs\\|nvrc\\|nvts\\|vsp\\)\\'" . arbprogram-mode))
  (add-to-list 'magic-mode-alist
               '("!!\\(?:ARB[fv]p\\|ATIfs\\|FP\\|VS?P\\|RC\\|TS\\)[12]\\.[01]" . arbprogram-mode)))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs '(arbprogram-mode . ("arbiter" "lsp"))))

(provide 'arbprogram-mode)
;;; arbprogram-mode.el ends here
