!!ARBvp1.0
MOV result.position, vertex.position;
END
