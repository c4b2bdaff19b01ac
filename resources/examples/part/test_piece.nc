%
O7917 (contouring test piece after ISO 10791-7)
N10 G21 G17 G90 G40 G80
N20 T1 M6 (end mill of 20 mm)
N30 G0 G54 G43 H1 X-95. Y-95. Z20. S3000 M3
(top face)
N40 G0 Z0.
(feature: top face)
N50 G1 X-80. Y-75. F2000
N60 G1 X80. Y-75.
N70 Y-60.
N80 G1 X-80. Y-60.
N90 Y-45.
N100 G1 X80. Y-45.
N110 Y-30.
N120 G1 X-80. Y-30.
N130 Y-15.
N140 G1 X80. Y-15.
N150 Y0.
N160 G1 X-80. Y0.
N170 Y15.
N180 G1 X80. Y15.
N190 Y30.
N200 G1 X-80. Y30.
N210 Y45.
N220 G1 X80. Y45.
N230 Y60.
N240 G1 X-80. Y60.
N250 Y75.
N260 G1 X80. Y75.
(feature: end)
N270 G0 Z20.
(outer square of 160 mm)
N280 G0 X-95. Y-110.
N290 G1 Z-50. F1000
N300 G41 D1 X-80. Y-95.
(feature: side left, straightness)
N310 G1 X-80. Y80. F1200
(feature: side rear, straightness)
N320 G1 X80. Y80. F1200
(feature: side right, straightness)
N330 G1 X80. Y-80. F1200
(feature: side front, straightness)
N340 G1 X-80. Y-80. F1200
(feature: end)
N350 X-95.
N360 G40 Y-110.
N370 G0 Z20.
(diamond of 112 mm, turned by 45 degrees)
N380 G0 X-105. Y-20.
N390 G1 Z-35. F1000
N400 G41 D1 X-89.196 Y-10.
N410 X-79.196 Y0.
(feature: diamond 1, straightness)
N420 G1 X0. Y79.196 F1200
(feature: diamond 2, straightness)
N430 G1 X79.196 Y0. F1200
(feature: diamond 3, straightness)
N440 G1 X0. Y-79.196 F1200
(feature: diamond 4, straightness)
N450 G1 X-79.196 Y0. F1200
(feature: end)
N460 X-89.196 Y10.
N470 G40 X-105. Y20.
N480 G0 Z20.
(sloping faces of 3 degrees)
N490 G0 X-70. Y-90.
N500 G1 Z-25. F1000
N510 G41 D1 X-60. Y-75.
N520 X-60. Y-60.
(feature: slope 1, straightness)
N530 G1 X-53.7111 Y60. F1200
(feature: end)
N540 Y75.
N550 G40 X-70. Y90.
N560 G0 Z20.
N570 G0 X-90. Y70.
N580 G1 Z-25. F1000
N590 G41 D1 X-75. Y60.
N600 X-60. Y60.
(feature: slope 2, straightness)
N610 G1 X60. Y53.7111 F1200
(feature: end)
N620 X75.
N630 G40 X90. Y70.
N640 G0 Z20.
(circle of 108 mm)
N650 G0 X-75. Y-15.
N660 G1 Z-20. F1000
N670 G41 D1 X-64. Y-10.
N680 G1 X-54. Y0.
(feature: circle, roundness)
N690 G2 X-54. Y0. I54. J0. F1200
(feature: end)
N700 G1 X-64. Y10.
N710 G40 X-75. Y15.
N720 G0 Z20.
(centre bore of 30 mm and four bores of 26 mm)
N730 G0 X0. Y0.
N740 G1 Z-2. F500
N750 G41 D1 X15. Y0. F300
(feature: centre bore, cylindricity)
N760 G3 X15. Y0. Z-7. I-15. J0. F600
N770 G3 X15. Y0. Z-12. I-15. J0. F600
N780 G3 X15. Y0. Z-17. I-15. J0. F600
N790 G3 X15. Y0. I-15. J0.
(feature: end)
N800 G1 G40 X0. Y0.
N810 G0 Z20.
N820 G0 X-52. Y-52.
N830 G1 Z-2. F500
N840 G41 D1 X-39. Y-52. F300
(feature: bore 1, cylindricity)
N850 G3 X-39. Y-52. Z-7. I-13. J0. F600
N860 G3 X-39. Y-52. Z-12. I-13. J0. F600
N870 G3 X-39. Y-52. Z-17. I-13. J0. F600
N880 G3 X-39. Y-52. I-13. J0.
(feature: end)
N890 G1 G40 X-52. Y-52.
N900 G0 Z20.
N910 G0 X52. Y-52.
N920 G1 Z-2. F500
N930 G41 D1 X65. Y-52. F300
(feature: bore 2, cylindricity)
N940 G3 X65. Y-52. Z-7. I-13. J0. F600
N950 G3 X65. Y-52. Z-12. I-13. J0. F600
N960 G3 X65. Y-52. Z-17. I-13. J0. F600
N970 G3 X65. Y-52. I-13. J0.
(feature: end)
N980 G1 G40 X52. Y-52.
N990 G0 Z20.
N1000 G0 X52. Y52.
N1010 G1 Z-2. F500
N1020 G41 D1 X65. Y52. F300
(feature: bore 3, cylindricity)
N1030 G3 X65. Y52. Z-7. I-13. J0. F600
N1040 G3 X65. Y52. Z-12. I-13. J0. F600
N1050 G3 X65. Y52. Z-17. I-13. J0. F600
N1060 G3 X65. Y52. I-13. J0.
(feature: end)
N1070 G1 G40 X52. Y52.
N1080 G0 Z20.
N1090 G0 X-52. Y52.
N1100 G1 Z-2. F500
N1110 G41 D1 X-39. Y52. F300
(feature: bore 4, cylindricity)
N1120 G3 X-39. Y52. Z-7. I-13. J0. F600
N1130 G3 X-39. Y52. Z-12. I-13. J0. F600
N1140 G3 X-39. Y52. Z-17. I-13. J0. F600
N1150 G3 X-39. Y52. I-13. J0.
(feature: end)
N1160 G1 G40 X-52. Y52.
N1170 G0 Z20.
(mounting holes)
N1180 T2 M6 (drill of 8 mm)
N1190 G0 G43 H2 X-70. Y0. Z20. S2000 M3
(feature: hole 1, position)
N1200 G98 G81 X-70. Y0. Z-30. R2. F200
(feature: hole 2, position)
N1210 X70.
(feature: end)
N1220 G80 G0 Z20.
N1230 M30
%
