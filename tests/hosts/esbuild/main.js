import "frond-ifs/view";
