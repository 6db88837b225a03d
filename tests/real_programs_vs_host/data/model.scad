difference() { cube(20, center=true); sphere(13, $fn=40); cylinder(h=40, r=5, center=true, $fn=30); }
translate([30,0,0]) intersection() { cube(18, center=true); sphere(12, $fn=40); rotate([45,0,0]) cube(16, center=true); }
