# Writes source_state.cpp with the state of the sources; only if it differs from what is there, so that
# a new commit recompiles one file.
set(VORONAUT_COMMIT unknown)
set(VORONAUT_DIRTY false)
find_program(git git)
if(git)
  execute_process(COMMAND "${git}" -C "${SOURCE_DIR}" rev-parse HEAD
    OUTPUT_VARIABLE commit RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(VORONAUT_COMMIT "${commit}")
    execute_process(COMMAND "${git}" -C "${SOURCE_DIR}" status --porcelain --untracked-files=no
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      set(VORONAUT_DIRTY true)
    endif()
  endif()
endif()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
