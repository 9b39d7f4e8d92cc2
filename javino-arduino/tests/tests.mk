# Rules of the tests, which Makefile includes.
#
#   make host      the tests on this machine, under the sanitizers
#   make vectors   the vectors of the protocol against the reference
#   make model     both ends of the protocol explored exhaustively
#   make tls       the example TlsRobot with mbedTLS, against a TLS client
#   make posix     the example for other families, compiled and run
#   make fuzz      the libFuzzer target (clang); run build/fuzz/decoder
#   make bare-metal   the core compiled with nothing but the C library of extras/bare-metal
#   make e2e       the sketches on the simulated ATmega328P
#   make cortex-m  the robot of extras/ and sketches for a Cortex-M3 without Arduino, and their sizes
#   make riscv     the same for a RISC-V microcontroller
#   make coldfire  the same for a ColdFire
#   make mips      the same for a MIPS32
#   make cortex-m-e2e, make riscv-e2e, make coldfire-e2e, make mips-e2e   those programs under QEMU
#   make mips-vectors   all vectors on a MIPS32
#   make 8051      the vectors on a simulated 8051; make 8051-differential: random streams there
#   make size      bytes of flash and RAM
#   make kits      the library as a part of ESP-IDF, Zephyr and pico-sdk projects, with stand-ins for these
#   make registries   what the Arduino IDE, PlatformIO and the ESP component registry read of the library
#   make split-off the folder as a repository of its own

# ---- host ----

SANITIZERS := -fsanitize=address,undefined -fno-sanitize-recover=all
SANITIZE := $(SANITIZERS) -O1 -g
# The tests' macros cost an optimizer four times what the compiler needs without it.
SANITIZE_TESTS := $(SANITIZERS) -O0 -g1
HOST := $(BUILD)/host
HOST_TESTS := $(wildcard tests/host/*.cpp)
TEST_CXX := $(CXX) -std=c++17 $(WARNINGS) $(SANITIZE_TESTS) -Isrc
WITH_HEADERS := -include $(HOST)/headers.h

$(HOST)/%.c.o: src/%.c $(HEADERS)
	@mkdir -p $(@D)
	$(CC) -std=c99 -pedantic $(WARNINGS) $(SANITIZE) -c $< -o $@

$(HOST)/%.cpp.o: src/%.cpp $(HEADERS) tests/stub/Arduino.h
	@mkdir -p $(@D)
	$(CXX) -std=c++11 $(WARNINGS) $(SANITIZE) -DARDUINO=10812 -Itests/stub -c $< -o $@

$(HOST)/headers.h.gch: tests/host/headers.h
	@mkdir -p $(@D)
	cp $< $(HOST)/headers.h
	$(TEST_CXX) -x c++-header $< -o $@

$(HOST)/test_network_test.o: $(BUILD)/sketches/WiFiRobot.cpp
$(HOST)/test_examples_test.o: $(BUILD)/sketches/Tasks.cpp $(BUILD)/sketches/SecondPort.cpp

# The one with doctest's own code includes it in a way of its own. That code is not what UBSan is to check.
$(HOST)/test_main.o: WITH_HEADERS := -fno-sanitize=undefined
# The compiler needs a third of its time for these checks of the JSON library's templates. AddressSanitizer finds null pointers, too, and
# these tests contain no code of the library.
$(HOST)/test_frame_test.o $(HOST)/test_vectors_test.o: WITH_HEADERS += -fno-sanitize=null,alignment,object-size,vptr
$(HOST)/test_%.o: tests/host/%.cpp $(HEADERS) $(wildcard tests/stub/*.h tests/stub/*/*.h) $(wildcard tests/host/*.h) $(HOST)/headers.h.gch
	$(TEST_CXX) $(WITH_HEADERS) -Itests/stub -Itests/stub/esp32 -I$(BUILD)/sketches -DVECTORS='"vectors/javino-vectors.json"' \
	  -DVECTORS_2='"vectors/javino2-vectors.json"' -c $< -o $@

$(HOST)/tests: $(C_SOURCES:src/%=$(HOST)/%.o) $(CXX_SOURCES:src/%=$(HOST)/%.o) $(HOST_TESTS:tests/host/%.cpp=$(HOST)/test_%.o)
	$(CXX) $(SANITIZE) $^ -o $@

# The core compiled in other ways, each with a test of its own: as AVR compiles it, with less text, and without what each switch leaves out.
# Folder, macro, test.
define VARIANT_RULE
$(HOST)/$(1)/%.o: src/%.c $(HEADERS)
	@mkdir -p $$(@D)
	$(CC) -std=c99 -pedantic $(WARNINGS) $(SANITIZE) -D$(2) -c $$< -o $$@
$(HOST)/$(1)/tests: $(C_SOURCES:src/%.c=$(HOST)/$(1)/%.o) $(3) $(wildcard tests/host/*.h) $(HOST)/test_main.o
	$(TEST_CXX) -include $(HOST)/headers.h -Itests/host -D$(2) $$(filter %.cpp %.o,$$^) -o $$@
endef
HOST_SWITCHES := JAVINO_VERSION_1_ONLY JAVINO_VERSION_2_ONLY JAVINO_NO_FUNCTOR_LISTS
$(eval $(call VARIANT_RULE,short,JAVINO_TEXT_MAX=255,tests/host/percepts_test.cpp))
$(foreach switch,$(HOST_SWITCHES),$(eval $(call VARIANT_RULE,$(switch),$(switch),tests/switches.cpp)))

# The examples compile against stand-ins of these cores' interfaces, and the class on a board that has no Serial.
CORES := esp32 esp8266 pico-w
esp32_FLAGS := -DESP32 -DARDUINO_ARCH_ESP32
esp8266_FLAGS := -DESP8266 -DARDUINO_ARCH_ESP8266
pico-w_FLAGS := -DARDUINO_ARCH_RP2040

define CORE_RULE
$(BUILD)/cores/$(1)/%.o: $(BUILD)/sketches/%.cpp $(HEADERS) $(wildcard tests/stub/*.h tests/stub/$(1)/*.h tests/stub/$(1)/*/*.h)
	@mkdir -p $$(@D)
	$(CXX) -std=gnu++11 $(WARNINGS) -DARDUINO=10812 $($(1)_FLAGS) -Itests/stub -Itests/stub/$(1) -Isrc -c $$< -o $$@
endef
$(foreach core,$(CORES),$(eval $(call CORE_RULE,$(core))))

$(BUILD)/cores/no_serial.o: tests/network/no_serial.cpp $(HEADERS) tests/stub/Arduino.h
	@mkdir -p $(@D)
	$(CXX) -std=c++11 $(WARNINGS) -DARDUINO=10812 -DSTUB_WITHOUT_SERIAL -Itests/stub -Isrc -c $< -o $@

cores: $(foreach core,$(CORES),$(patsubst %.ino,$(BUILD)/cores/$(core)/%.o,$(notdir $($(core)_SKETCHES)))) $(BUILD)/cores/no_serial.o
	@echo "ok   examples compile against stand-ins of $(CORES)"

switches: $(HOST_SWITCHES:%=$(HOST)/%/tests)
	@for switch in $(HOST_SWITCHES); do $(HOST)/$$switch/tests -m || exit 1; done
	@echo "ok   the core without what $(HOST_SWITCHES) leave out"

host-short: $(HOST)/short/tests
	$(HOST)/short/tests

host: $(HOST)/tests $(HOST)/short/tests cores switches
	$(HOST)/tests
	$(HOST)/short/tests

# The core driven by a test, as a program of its own.
DRIVEN := tests/driven/board.c tests/driven/hosted.c $(C_SOURCES)
DRIVEN_HEADERS := tests/driven/stream.h $(HEADERS)
$(HOST)/driven: $(DRIVEN) $(DRIVEN_HEADERS)
	@mkdir -p $(@D)
	$(CC) -std=c99 -pedantic $(WARNINGS) $(SANITIZE) -Isrc $(DRIVEN) -o $@

# TlsRobot with mbedTLS, on this machine's sockets.
TLS_FLAGS := -std=gnu++11 $(WARNINGS) $(SANITIZE) -DARDUINO=10812 -DESP32 -Itests/tls -Itests/stub -Isrc

$(BUILD)/tls/certificates.h: tests/tls/certificates
	tests/tls/certificates $(@D)

$(BUILD)/tls/board: tests/tls/board.cpp $(BUILD)/sketches/TlsRobot.cpp $(BUILD)/tls/certificates.h $(wildcard examples/TlsRobot/*.h tests/tls/*.h tests/stub/*.h) \
  $(C_SOURCES:src/%=$(HOST)/%.o) $(CXX_SOURCES:src/%=$(HOST)/%.o)
	$(CXX) $(TLS_FLAGS) -iquote $(BUILD)/tls -iquote $(BUILD)/sketches -iquote examples/TlsRobot $(filter %board.cpp %.o,$^) \
	  -lmbedtls -lmbedx509 -lmbedcrypto -o $@

tls: $(BUILD)/tls/board
	python3 tests/e2e/tls.py $(BUILD)/tls

vectors:
	python3 vectors/reference.py

model: model-explored model-defects
model-explored:
	python3 tests/model.py
model-defects:
	python3 tests/model.py --mutations

differential: $(HOST)/driven
	python3 tests/driven_vectors.py $<
	python3 tests/differential.py $<

# ---- other families ----

$(BUILD)/posix/board: extras/posix/board.c $(C_SOURCES) $(HEADERS)
	@mkdir -p $(@D)
	$(CC) -std=c99 -pedantic $(WARNINGS) -O2 -Isrc $(filter %.c,$^) -o $@

posix: $(BUILD)/posix/board
	python3 tests/e2e/posix.py $<

# ---- fuzzing ----

$(BUILD)/fuzz/decoder: tests/fuzz/decoder.c $(C_SOURCES) $(HEADERS)
	@mkdir -p $(@D)
	clang -std=c99 $(WARNINGS) -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -Isrc $(filter %.c,$^) -o $@

# From the vectors' conversations, 50,000 runs reach more of the core than 200,000 runs from nothing.
FUZZ_RUNS := 50000
fuzz: $(BUILD)/fuzz/decoder
	rm -rf $(BUILD)/fuzz/seeds $(BUILD)/fuzz/found
	mkdir $(BUILD)/fuzz/seeds $(BUILD)/fuzz/found
	python3 tests/fuzz/seeds.py $(BUILD)/fuzz/seeds
	$< -runs=$(FUZZ_RUNS) -max_len=1024 -seed=1 -verbosity=0 -print_final_stats=1 $(BUILD)/fuzz/found $(BUILD)/fuzz/seeds

# ---- sizes on AVR ----

# The core alone, without what links it away.
CORE := $(BUILD)/avr/javino_frame.o $(BUILD)/avr/javino_decoder.o $(BUILD)/avr/javino_link.o
$(CORE): $(BUILD)/avr/%.o: src/%.c $(HEADERS)
	@mkdir -p $(@D)
	avr-gcc -mmcu=atmega328p -std=c99 -Os $(WARNINGS) -c $< -o $@

# Blink without version 2.
version1:
	$(MAKE) BUILD=$(BUILD)/version1 VERSIONS=-DJAVINO_VERSION_1_ONLY $(BUILD)/version1/avr/uno/Blink.elf

# What each feature takes, and what each switch spares.
SWITCHES := JAVINO_VERSION_1_ONLY JAVINO_VERSION_2_ONLY JAVINO_NO_FUNCTOR_LISTS JAVINO_NO_DECIMALS
FEATURES := NO_LIBRARY SMALLEST ACTION BOARD_ACTION FLASH_ACTION NUMBER DECIMAL UNKNOWN LATER WHOLE TEXT FLASH_TEXT TWO_DECIMALS \
  SIX_DECIMALS WHOLE_64 DESCRIBE COUNTERS LOST RULES

$(BUILD)/features/%.elf: tests/features/features.cpp $(HEADERS) $(UNO_LIBRARY) $(AVR_CORES)/uno/core.a
	@mkdir -p $(@D)
	$(AVR_CXX) $(uno_FLAGS) $(WARNINGS) -Isrc -DFEATURE_$* -c $< -o $(@:.elf=.o)
	$(AVR_LINK) -mmcu=atmega328p $(@:.elf=.o) $(UNO_LIBRARY) $(AVR_CORES)/uno/core.a -lm -o $@

features: $(FEATURES:%=$(BUILD)/features/%.elf)
	@for switch in $(SWITCHES); do \
	  program=SMALLEST; [ $$switch != JAVINO_NO_FUNCTOR_LISTS ] || program=WHOLE; \
	  $(MAKE) BUILD=$(BUILD)/switches/$$switch VERSIONS=-D$$switch $(BUILD)/switches/$$switch/features/$$program.elf && \
	    cp $(BUILD)/switches/$$switch/features/$$program.elf $(BUILD)/features/$$switch.elf || exit 1; \
	done

size: avr $(CORE) version1 features
	@tests/sizes
	@tests/features/table

# ---- only with the C library of extras/bare-metal ----

# The compiler of this machine finds what is missing there.
bare-metal:
	$(CC) -std=gnu99 -Os -ffreestanding $(WARNINGS) -fsyntax-only -nostdinc -isystem "$$($(CC) -print-file-name=include)" \
	  -Iextras/bare-metal/libc -Isrc -Iextras/bare-metal $(C_SOURCES) extras/bare-metal/libc/string.c

# ---- on the simulated Uno ----

e2e: sim avr
	python3 tests/e2e/simulated.py $(E2E)

# ---- microcontrollers without Arduino, under QEMU ----

MACHINES := cortex-m riscv coldfire mips
cortex-m_PREFIX := arm-none-eabi
cortex-m_FLAGS := -mcpu=cortex-m3 -mthumb
riscv_PREFIX := riscv64-unknown-elf
# The older set has the instructions for control registers in the base.
riscv_FLAGS := -march=rv32imac -mabi=ilp32 -misa-spec=2.2
coldfire_PREFIX := m68k-linux-gnu
# A compiler for Linux; its note would lie before the vectors.
coldfire_FLAGS := -mcpu=5208 -fno-pic -fno-asynchronous-unwind-tables -Wl,--build-id=none -Wl,--no-warn-rwx-segments
mips_PREFIX := mipsel-linux-gnu
# A compiler for Linux, whose code need not move.
mips_FLAGS := -march=24kf -fno-pic -mno-shared -mplt -G0 -no-pie -static -Wl,--build-id=none -Wl,--no-warn-rwx-segments

# A function of string.c is not to call itself.
MACHINE_FLAGS := -Os -ffreestanding -fno-tree-loop-distribute-patterns -ffunction-sections -fdata-sections $(WARNINGS) \
  -Itests/machines -Iextras/bare-metal/libc -Isrc -Iextras/bare-metal
MACHINE_C := -std=gnu99 $(MACHINE_FLAGS)
MACHINE_CXX := -DARDUINO=10812 -std=gnu++11 -fno-exceptions -fno-rtti -fno-threadsafe-statics $(MACHINE_FLAGS)
MACHINE_HEADERS := $(HEADERS) $(wildcard extras/bare-metal/*.h tests/machines/*.h extras/bare-metal/libc/*.h)
MACHINE_OBJECTS := machine.c start.c pins.c string.c $(C_SOURCES:src/%=%)
SKETCH_OBJECTS := sketch.cpp $(MACHINE_OBJECTS) $(CXX_SOURCES:src/%=%)
MACHINE_SKETCHES := Blink Bare LinkLost Gripper Robot4WD Echo Stall
vpath %.c src extras/bare-metal extras/bare-metal/libc tests/driven
vpath %.cpp src tests/machines

define MACHINE_RULES
$(BUILD)/$(1)/%.c.o: %.c $(MACHINE_HEADERS)
	@mkdir -p $$(@D)
	$($(1)_PREFIX)-gcc $($(1)_FLAGS) $$(MACHINE_C) -c $$< -o $$@
$(BUILD)/$(1)/machine.c.o: extras/$(1)/machine.c $(MACHINE_HEADERS)
	@mkdir -p $$(@D)
	$($(1)_PREFIX)-gcc $($(1)_FLAGS) $$(MACHINE_C) -c $$< -o $$@
$(BUILD)/$(1)/%.cpp.o: %.cpp $(MACHINE_HEADERS)
	@mkdir -p $$(@D)
	$($(1)_PREFIX)-g++ $($(1)_FLAGS) $$(MACHINE_CXX) -c $$< -o $$@
$(BUILD)/$(1)/%.sketch.o: $(BUILD)/sketches/%.cpp $(MACHINE_HEADERS)
	@mkdir -p $$(@D)
	$($(1)_PREFIX)-g++ $($(1)_FLAGS) $$(MACHINE_CXX) -c $$< -o $$@
$(BUILD)/$(1)/robot.elf: $(patsubst %,$(BUILD)/$(1)/%.o,robot.c $(MACHINE_OBJECTS)) extras/$(1)/link.ld
	$($(1)_PREFIX)-gcc $($(1)_FLAGS) -nostdlib -Wl,--gc-sections -T extras/$(1)/link.ld $$(filter %.o,$$^) -lgcc -o $$@
$(BUILD)/$(1)/%.elf: $(BUILD)/$(1)/%.sketch.o $(patsubst %,$(BUILD)/$(1)/%.o,$(SKETCH_OBJECTS)) extras/$(1)/link.ld
	$($(1)_PREFIX)-gcc $($(1)_FLAGS) -nostdlib -Wl,--gc-sections -T extras/$(1)/link.ld $$(filter %.o,$$^) -lgcc -o $$@
.PHONY: $(1) $(1)-e2e
$(1): $(patsubst %,$(BUILD)/$(1)/%.elf,robot $(MACHINE_SKETCHES))
	@tests/machines/sizes $(1) $($(1)_PREFIX)
$(1)-e2e: $(patsubst %,$(BUILD)/$(1)/%.elf,robot $(MACHINE_SKETCHES))
	python3 tests/e2e/simulated.py --board $(1)
endef
$(foreach machine,$(MACHINES),$(eval $(call MACHINE_RULES,$(machine))))

# The tests of all vectors, as a program for Linux on a MIPS32.
$(BUILD)/mips/vectors: $(C_SOURCES) tests/host/main.cpp tests/host/frame_test.cpp tests/host/vectors_test.cpp $(HEADERS) $(wildcard tests/host/*.h)
	@mkdir -p $@.objects
	cd $@.objects && mipsel-linux-gnu-gcc -std=c99 -O1 -c $(C_SOURCES:%=$(CURDIR)/%)
	mipsel-linux-gnu-g++ -std=c++17 $(WARNINGS) -O0 -static -Isrc -Itests/stub -idirafter /usr/include -DVECTORS='"vectors/javino-vectors.json"' \
	  -DVECTORS_2='"vectors/javino2-vectors.json"' $(filter %.cpp,$^) $@.objects/*.o -o $@

mips-vectors: $(BUILD)/mips/vectors
	qemu-mipsel $< -tc='*vectors*'

# ---- an 8051, in sdcc's simulator ----

# Functions that are called by pointers take their arguments from the stack; it is the only thing in internal memory.
SDCC := sdcc -mmcs51 --model-large --stack-auto --std-c99 --Werror -Isrc -Itests/driven

$(BUILD)/8051/%.rel: %.c $(DRIVEN_HEADERS)
	@mkdir -p $(@D)
	$(SDCC) -c $< -o $@

$(BUILD)/8051/driven.ihx: $(patsubst %.c,$(BUILD)/8051/%.rel,board.c mcs51.c $(C_SOURCES:src/%=%))
	$(SDCC) $^ -o $@

.PHONY: mips-vectors 8051 8051-differential
8051: $(BUILD)/8051/driven.ihx
	@tests/driven/sizes
	python3 tests/driven_vectors.py $<
STREAMS_8051 := 50
8051-differential: $(BUILD)/8051/driven.ihx
	python3 tests/differential.py --streams $(STREAMS_8051) --seed 2 $<

# ---- kits and registries ----

KITS := esp-idf esp-idf-arduino zephyr zephyr-version1 pico-sdk

# Each kit's project prints the same answer of its board.
kits: $(KITS:%=$(BUILD)/kits/%)
	@echo "ok   the library is a part of $(KITS)"

$(BUILD)/kits/%: CMakeLists.txt tests/cmake/CMakeLists.txt tests/cmake/program.c $(C_SOURCES) $(CXX_SOURCES) $(HEADERS)
	cmake -S tests/cmake -B $@.build -DKIT=$* > $@.log 2>&1 || { cat $@.log; false; }
	cmake --build $@.build > $@.log 2>&1 || { cat $@.log; false; }
	$@.build/program > $@
	echo -n 'fffe0Alight(40);' | cmp - $@

$(KITS:%=$(BUILD)/kits/%): | $(BUILD)/kits
$(BUILD)/kits:
	mkdir -p $@

registries:
	./package > /dev/null
	python3 tests/registries.py

# The split is this folder as it was committed, with every commit that changed it in a history of this depth, behind which the copy has
# no parents. git takes long for each commit; .ci/long splits all.
HISTORY := 200
RECENT := $(BUILD)/recent
split-off:
	rm -rf $(BUILD)/split $(RECENT)
	git clone -q --no-checkout --depth $(HISTORY) "file://$$(git rev-parse --show-toplevel)" $(RECENT)
	git -C $(RECENT) checkout -q HEAD -- "$$(git rev-parse --show-prefix)"
	cd $(RECENT)/.git && if [ -e shallow ]; then xargs -n 1 git replace --graft < shallow && rm shallow; fi
	"$(RECENT)/$$(git rev-parse --show-prefix)split" $(BUILD)/split
	test "$$(git -C $(BUILD)/split rev-parse HEAD^{tree})" = "$$(git rev-parse HEAD:./)"
	test "$$(git -C $(BUILD)/split rev-list --count --no-merges HEAD)" = \
	  "$$(git -C $(RECENT) rev-list --count --no-merges --full-history HEAD -- "$$(git rev-parse --show-prefix)")"
