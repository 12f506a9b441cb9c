# Reads a compile database as CMake writes it and the list of files to take from it; puts files of one floor, program or
# kind of test that are compiled with the same options together, one #include each, at most `size` in a batch:
#   awk -v top=SOURCE_DIR -v out=FOLDER_IN_IT -v size=N -f lint_batches.awk LIST compile_commands.json
# makes FOLDER/renderer/astro_1/batch.cpp and beside it a compile database of that one file; prints the batches' folders.
BEGIN { FS = "\"" }
NR == FNR { listed[top "/" $0] = 1; next }
/"command":/ { command = $0 }
/"file":/ && ($4 in listed) {
  delete listed[$4] # once, though two programs may compile it
  options = command
  sub(/ -o [^ ]+ -c .*/, "", options)
  sub(/-fPIE/, "-fPIC", options) # a library's or a program's file: all the same here
  count = split(substr($4, length(top) + 2), part, "/")
  place = part[1] "/" (count > 2 ? part[2] : "sources")
  if (!(place in total)) { total[place] = 0 }
  key = place SUBSEP options
  if (in_batch[key] % size == 0) {
    batch[key] = out "/" place "_" ++total[place]
    system("mkdir -p " batch[key])
    file = top "/" batch[key] "/batch.cpp"
    database = batch[key] "/compile_commands.json"
    printf "[{\n  \"directory\": \"%s\",\n%s -o batch.o -c %s\",\n  \"file\": \"%s\"\n}]\n", top, options, file, file >database
    close(database)
    print batch[key]
  }
  in_batch[key]++
  print "#include \"" $4 "\"" >>(batch[key] "/batch.cpp")
  close(batch[key] "/batch.cpp")
}
