bGaj
