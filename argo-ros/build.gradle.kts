plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // what a bridge is sent and sends
    testImplementation(libs.jason)
    testImplementation(libs.java.websocket) // the tests' own bridge
    testImplementation(libs.slf4j.jdk14) // where it logs to
}

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }
