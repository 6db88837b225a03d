# a comment
!!ARBfp1.0
END
