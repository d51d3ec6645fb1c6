# a list
cPcbbbiht_BaCB(1,2) 4_1
cPcbbbiht_12bkaaid
