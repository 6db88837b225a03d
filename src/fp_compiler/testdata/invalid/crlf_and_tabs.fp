!!ARBfp1.0
# café
	TEMP	a;
	MOV	a,	b;
END
