dependencies {
    // packed into the jar, with all that they need but Jason
    runtimeOnly(project(":argo-arch"))
    runtimeOnly(project(":argo-view"))
    runtimeOnly(project(":argo-ros"))
    runtimeOnly(project(":argo-recording"))
    runtimeOnly(project(":argo-tools"))
    // the packer
    compileOnly(libs.asm.commons)
    testImplementation(libs.asm.commons)
    testImplementation(libs.archunit) // the specs on which package may know which
}

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }

/** The one jar that a Jason project adds: everything but Jason. */
val argoJar by tasks.registering(JavaExec::class) {
    description = "Packs argo.jar."
    val jar = layout.buildDirectory.file("libs/argo.jar")
    val packed = files(configurations.runtimeClasspath)
    val version = project.version.toString()
    inputs.files(packed)
    inputs.property("version", version)
    outputs.file(jar)
    classpath(sourceSets.main.map { it.output }, configurations.compileClasspath)
    mainClass = "argo.packing.MainKt"
    argumentProviders.add(CommandLineArgumentProvider { listOf(jar.get().asFile.path, version, packed.asPath) })
}

tasks.assemble { dependsOn(argoJar) }

tasks.test {
    dependsOn(argoJar)
    systemProperty("argo.jar", layout.buildDirectory.file("libs/argo.jar").get().asFile.path)
}
